/**
 * Chinese for the papers' questions of experiments/*.toml and the names of their maps: by the English text, as it stands in documents,
 * so that a question from a file or a link is told as well as one from the list.
 */
export const zhCNQuestions: Record<string, string> = {
  // Titles.
  'The classics against Ant System': '经典蚁群算法与蚂蚁系统',
  'Fire-fighting robot with several fires': '面对多个火源的灭火机器人',
  'Fireworks, ants, and ants after fireworks': '烟花、蚂蚁，以及烟花之后的蚂蚁',
  'Engine-room ACO against the basic ACO': '机舱蚁群算法与基本蚁群算法',
  'Elitist potential-field ACO against its basic ACO and PSO':
    '精英势场蚁群算法与其基本蚁群算法和粒子群算法',
  'Ant colony with an adaptive threshold against ACO and ACOMSP':
    '自适应阈值蚁群算法与 ACO 和 ACOMSP',

  // Where they come from.
  'Zhang, Wang, Sun, Liu, Wu, Liu 2020, Application of improved ant colony algorithm in multi-fire path planning of fire fighting robot, table 2':
    '张森、王奔、孙梦亚、刘月锟、武曲、刘秀燕 2020，改进的蚁群算法在灭火机器人多火源路径规划的应用，表 2',
  'Zhou, Mu, Zhang 2019, Path planning of mobile robot based on hybrid FWA and ACO, table 1, section 2.2 (200 ants; comparison with particles)':
    '周森鹏、穆平安、张仁杰 2019，基于烟花混合蚁群的移动机器人路径规划研究，表 1，第 2.2 节（200 只蚂蚁；与粒子群比较）',
  'Fan, Zhang, Liu, Zhu 2026, Journal of Dalian Maritime University 52(1), 87–98, tables 1 and 2, section 4.3; doi:10.16411/j.cnki.issn1006-7736.2026.01.009':
    '范学兴、张彬、刘世翔、朱文斌 2026，大连海事大学学报 52(1)，87–98，表 1 与表 2，第 4.3 节；doi:10.16411/j.cnki.issn1006-7736.2026.01.009',
  'Robot 3D path planning by an improved elitist potential-field ant colony (基于改进精英势场蚁群算法的机器人三维路径规划算法研究), Hans Publishers, article 41567, tables 2 and 3':
    '基于改进精英势场蚁群算法的机器人三维路径规划算法研究，汉斯出版社，文章 41567，表 2 与表 3',
  'Lai, Guo 2014, Ant Colony Optimization Based on Self-Adaption Threshold for Path Planning, tables 1 and 2, figure 5':
    '赖智铭、郭躬德 2014，基于自适应阈值蚁群算法的路径规划算法，表 1 与表 2，图 5',

  // What they ask.
  "Do the successors of Ant System find shorter paths than it does, as they do on tours (Dorigo and Stützle 2004, chapter 3), when each constructs 5000 paths? Parameters are the defaults here: the book's where it has them. A question of our own: no size is claimed.":
    '各构造 5000 条路径时，蚂蚁系统的后继算法能否如在旅行商问题上那样（Dorigo 与 Stützle 2004，第 3 章）找到比它更短的路径？参数取此处的默认值：书中给出的取书中的值。这是我们自己的问题：没有所称的大小。',
  "Do the weighted order and the pseudo-random proportional rule give a path of less weight R, with fewer turns and sooner, with the paper's parameters? The paper's walls are a figure, so they are ours; start, fires and their weights give its order table (table 1, figure 4). The table's index, 54.02 and 49.71, is called R in the text, the length of each leg times the weight of its fire, though legs of these lengths cannot weigh that much; only its relative difference is compared.":
    '采用论文的参数，加权次序与伪随机比例规则能否更快地给出权重 R 更小、转弯更少的路径？论文的墙只是一张图，因此墙是我们画的；起点、火源及其权重能得出论文的次序表（表 1，图 4）。表中的综合指标 54.02 与 49.71 在正文中称为 R，即各段长度乘以所到火源的权重，但这样长的路段不可能有这么大的权重；因此只比较相对差别。',
  "Does the hybrid find shorter paths than its parts, and sooner, with the paper's parameters? The paper's map is a figure, so the map is ours, of its size and in its style. The hybrids' iterations and constructed paths count both stages: 50 iterations of fireworks or particles come first. Subtract 50 from their iteration of best to compare with the paper's curve, which begins with the ants.":
    '采用论文的参数，混合算法能否比其组成部分更快地找到更短的路径？论文的地图只是一张图，因此地图是我们的，大小与风格相同。混合算法的迭代次数与构造的路径数把两个阶段都计入：先是烟花或粒子的 50 次迭代。与论文从蚂蚁开始的曲线比较时，请从最优所在迭代中减去 50。',
  "Does the improved algorithm find shorter paths with fewer turns in fewer iterations than the basic ant colony, with the paper's parameters? The paper's maps are figures, so the maps are ours, of its sizes and in its style. Its improved paths are refined by line of sight (section 3.3); so are ours, and length and turns are those of the refined path. The basic colony's are not refined, in the paper neither; so the search is also compared by itself, with both unrefined and with both refined, without a claimed size.":
    '采用论文的参数，改进算法能否比基本蚁群以更少的迭代找到更短、转弯更少的路径？论文的地图只是图，因此地图是我们的，大小与风格相同。论文的改进路径按视线拉直（第 3.3 节），我们的也是，长度与转弯取自拉直后的路径。基本蚁群的路径不拉直，论文中也是如此；因此还单独比较搜索本身：两者都不拉直，以及两者都拉直，此时没有所称的大小。',
  "Does the improved algorithm find cheaper paths than the basic ant colony and particle swarms, in fewer iterations, with the paper's parameters? By slices, the cost Σ √(1 + Δy² + Δh²) + |h| is what the paper calls length: its numbers are of that scale on the one terrain that is known (see the paper card). The terrains here are ours: made by a seeded generator, in the paper's sizes; and one more on the ground, with 16 moves, where length counts.":
    '采用论文的参数，改进算法能否比基本蚁群和粒子群以更少的迭代找到代价更低的路径？按切片移动时，论文所说的长度就是代价 Σ √(1 + Δy² + Δh²) + |h|：在唯一已知的地形上，论文的数字正是这个量级（见论文卡片）。这里的地形是我们的：由给定种子的生成器生成，大小与论文相同；另有一张沿地面、16 方向，以长度为准。',
  "Does ACOST find shorter paths than ACOMSP, and in the harder environment than ACO, with the paper's parameters? The paper's environments are figures, so the maps are ours, of its size and in its style. In environment I the paper gives ACOST and ACO the same length; nothing is claimed about the two there.":
    '采用论文的参数，ACOST 能否找到比 ACOMSP 更短的路径，并在较难的环境中优于 ACO？论文的环境只是图，因此地图是我们的，大小与风格相同。在环境 I 中，论文给出的 ACOST 与 ACO 长度相同；对这两者在该处没有主张。',

  // Maps.
  'Compartment, 20 × 20': '船舱，20 × 20',
  'Compartment, 30 × 30': '船舱，30 × 30',
  'Criss-cross, 20 × 20': '纵横障碍，20 × 20',
  'Engine room, 40 × 30': '船舶机舱，40 × 30',
  'Five places, 20 × 20': '多处火源，20 × 20',
  'Hills, 20 × 20': '丘陵，20 × 20',
  'Hills, 30 × 30': '丘陵，30 × 30',
  'Hills, 50 × 50': '丘陵，50 × 50',
  'Hills, 64 × 64, on the ground': '丘陵，64 × 64，沿地面',
  'Threshold environment I, 20 × 20': '阈值论文环境 I，20 × 20',
  'Threshold environment II, 20 × 20': '阈值论文环境 II，20 × 20',
  'Our map.': '我们的地图。',
  "Our map; stands for the paper's 20 × 20 grid with four fires (figures 1 and 6, table 2).":
    '我们的地图；代表论文中有四个火源的 20 × 20 栅格（图 1 与图 6，表 2）。',
  "Our map; stands for the paper's 20 × 20 grid with criss-cross obstacles (table 1).":
    '我们的地图；代表论文中有纵横交错障碍的 20 × 20 栅格（表 1）。',
  "Our map; stands for the paper's 20 × 20 grid (table 1).":
    '我们的地图；代表论文的 20 × 20 栅格（表 1）。',
  "Our map; stands for the paper's 30 × 30 grid (table 2).":
    '我们的地图；代表论文的 30 × 30 栅格（表 2）。',
  "Our map; stands for the paper's engine-room plan (figure 9).":
    '我们的地图；代表论文的机舱平面图（图 9）。',
  "Our map; stands for the paper's environment I.": '我们的地图；代表论文的环境 I。',
  "Our map; stands for the paper's environment II.": '我们的地图；代表论文的环境 II。',
  "Our terrain, `formicarium generate hills --size 21x21 --seed 1`, 20 steps from end to end; stands for the paper's 20 × 20 (table 3), whose own terrain by its numbers is the textbook's (see the card). The ends are ours: from the middle of the left edge to 8/21 of the height of the right one, as on the textbook's terrain, each at the lowest level above the ground there; 20 levels, the tenth as high as the highest ground.":
    '我们的地形，`formicarium generate hills --size 21x21 --seed 1`，从一端到另一端 20 步；代表论文的 20 × 20（表 3），从其数字看，论文自己的地形就是教材的地形（见卡片）。起点与终点是我们定的：从左边中点到右边高度的 8/21 处，与教材的地形相同，各取该处地面以上的最低层；共 20 层，第十层与最高的地面同高。',
  "Our terrain, `formicarium generate hills --size 31x31 --seed 1`; stands for the paper's 30 × 30 (table 3). Ends and levels as on hills-20.":
    '我们的地形，`formicarium generate hills --size 31x31 --seed 1`；代表论文的 30 × 30（表 3）。起点、终点与层同 hills-20。',
  "Our terrain, `formicarium generate hills --size 51x51 --seed 1`; stands for the paper's 50 × 50 (table 3). Ends and levels as on hills-20.":
    '我们的地形，`formicarium generate hills --size 51x51 --seed 1`；代表论文的 50 × 50（表 3）。起点、终点与层同 hills-20。',
  'Our terrain, `formicarium generate hills --size 65x65 --seed 1`, from corner to corner on the ground; stands for no map of the paper.':
    '我们的地形，`formicarium generate hills --size 65x65 --seed 1`，沿地面从一角到对角；不代表论文的任何地图。',

  // Entries.
  'Ant System': '蚂蚁系统',
  'Elitist Ant System': '精英蚂蚁系统',
  'Rank-based Ant System': '基于排序的蚂蚁系统',
  'MAX–MIN Ant System': '最大最小蚂蚁系统',
  'Ant Colony System': '蚁群系统',
  'basic: shortest order, eq. 3': '基本：最短次序，式 3',
  'improved: weighted order, eq. 9': '改进：加权次序，式 9',
  'weighted order, eq. 3 for the legs': '加权次序，路段用式 3',
  'improved, eq. 9 for the order too': '改进，次序也用式 9',
  'improved, ρ as printed': '改进，ρ 按印刷公式',
  'basic, ρ as printed': '基本，ρ 按印刷公式',
  'improved, order by paths on the map': '改进，按地图上的路径定次序',
  fireworks: '烟花',
  'improved fireworks': '改进烟花',
  'ACO, 50 ants': 'ACO，50 只蚂蚁',
  'ACO, 200 ants': 'ACO，200 只蚂蚁',
  'fireworks, then ants': '先烟花后蚂蚁',
  'particles, then ants': '先粒子后蚂蚁',
  'fireworks, then ants that do not know of them': '先烟花后蚂蚁，蚂蚁不知道烟花的结果',
  'fireworks, then ants, ρ = 0.9 evaporates': '先烟花后蚂蚁，ρ = 0.9 为挥发部分',
  'basic ACO, η = 1/(distance to the goal)': '基本蚁群，η = 1/(到终点的距离)',
  'basic ACO, η = 1/step as printed': '基本蚁群，η = 1/步长，按印刷公式',
  'basic ACO, its path refined as well': '基本蚁群，路径也拉直',
  'improved ACO, update by eq. 12 as its step 4 says': '改进蚁群，按其第 4 步以式 12 更新',
  'improved ACO, refined node by node (section 3.3 word by word)':
    '改进蚁群，逐点拉直（第 3.3 节照字面）',
  'ref. 20 (Zhou et al. 2022)': '文献 20（Zhou 等 2022）',
  'its formulas are not published in the source': '来源中没有给出其公式',
  'improved ACO': '改进蚁群',
  'improved ACO without refinement': '改进蚁群，不拉直',
  'improved ACO, everything as printed': '改进蚁群，全部按印刷公式',
  'basic ACO, η = 1/step as eq. 2 prints': '基本蚁群，η = 1/步长，按印刷的式 2',
  'basic ACO, both distances as in the textbook': '基本蚁群，两种距离，同教材',
  'particle swarm': '粒子群',
  'improved ACO, 50 ants in each colony': '改进蚁群，每队 50 只蚂蚁',
  'improved ACO, η = 1/step as eq. 2 prints': '改进蚁群，η = 1/步长，按印刷的式 2',
  'improved ACO, both distances as in the textbook': '改进蚁群，两种距离，同教材',
  'improved ACO without the first trails of the field': '改进蚁群，不用势场初始化信息素',
  'improved ACO without the force': '改进蚁群，不用势场力',
  'improved ACO without the elite': '改进蚁群，不用精英策略',
  'improved ACO from the start alone': '改进蚁群，只从起点出发',
  ACO: 'ACO',
  ACOMSP: 'ACOMSP',
  ACOST: 'ACOST',
  'ACOST, as printed': 'ACOST，按印刷公式',

  // Claims.
  'shorter paths': '路径更短',
  'less weight R of the whole path': '整条路径的权重 R 更小',
  'fewer turns, a smoother path': '转弯更少，路径更平滑',
  'fewer iterations until convergence': '收敛所需迭代更少',
  'a little length is given up for it': '为此路径略长',
  'fewer turns by eq. 9 alone: the same order, the same legs': '仅因式 9 转弯更少：次序与路段相同',
  'fewer iterations by eq. 9 alone': '仅因式 9 迭代更少',
  'out of local optima by eq. 9 alone: less weight R with the same order':
    '仅因式 9 跳出局部最优：次序相同而权重 R 更小',
  'less weight R when the order is chosen by paths on the map (ours)':
    '按地图上的路径定次序时权重 R 更小（我们的做法）',
  'converges in fewer iterations, both stages counted': '收敛所需迭代更少，两个阶段都计入',
  'shorter paths even than with 200 ants (the paper: the same length)':
    '路径甚至短于 200 只蚂蚁（论文：长度相同）',
  'finds its best after fewer constructed paths, both stages counted':
    '找到最优前构造的路径更少，两个阶段都计入',
  "shorter paths because of the fireworks' trail (our question: the same colony without it)":
    '因烟花留下的信息素而路径更短（我们的问题：与没有它的同一蚁群比较）',
  "fewer iterations because of the fireworks' trail (our question: the same colony without it)":
    '因烟花留下的信息素而迭代更少（我们的问题：与没有它的同一蚁群比较）',
  'shorter paths by cooling': '因退火而路径更短',
  'fewer turns': '转弯更少',
  'fewer iterations': '迭代更少',
  'shorter paths by the search alone': '仅就搜索而言路径更短',
  'fewer turns by the search alone': '仅就搜索而言转弯更少',
  "shorter paths, where the basic ACO's path is refined by the same rule: what the search itself gains":
    '基本蚁群的路径按同样规则拉直时仍更短：搜索本身的收益',
  "fewer turns, where the basic ACO's path is refined by the same rule: what the search itself gains":
    '基本蚁群的路径按同样规则拉直时转弯仍更少：搜索本身的收益',
  'cheaper paths': '路径代价更低',
  'cheaper paths, with 50 ants in each colony': '路径代价更低，每队 50 只蚂蚁',
  'cheaper paths, both with η = 1/step as printed': '路径代价更低，两者的 η 均为印刷的 1/步长',
  'cheaper paths, both with both distances': '路径代价更低，两者均用两种距离',
  'shorter paths on the ground': '沿地面的路径更短',
  'cheaper paths by the first trails of the field': '因势场初始化信息素而代价更低',
  'cheaper paths by the force': '因势场力而代价更低',
  'cheaper paths by the elite': '因精英策略而代价更低',
  'cheaper paths by the second colony': '因第二队蚂蚁而代价更低',
  'ACOMSP converges faster': 'ACOMSP 收敛更快',
  'finds a path where there is one, more often (our question: the paper says that it finds a good one quickly, not how often)':
    '有路可走时更常找到路径（我们的问题：论文说它很快找到较优的路径，没有说多常）',

  // What a reader of the verdicts must know.
  "The refined path may take any angle, the baseline's may not: part of the difference is refinement, which would shorten the baseline's paths as well. The search is also compared by itself.":
    '拉直后的路径可取任意角度，基线的路径不能：差别有一部分来自拉直，它同样会缩短基线的路径。搜索本身另作比较。',
  'Not independent: μ, ω, γ and k are not given in the paper, and their values here were chosen because an earlier trial on public grids showed few iterations with them.':
    '并非独立的检验：论文没有给出 μ、ω、γ 与 k，这里的取值是因为此前在公开栅格地图上的试验用它们迭代较少。',
  'The paper gives one number of ants and two colonies; our default splits it, so that both algorithms construct 50 walks an iteration. Ants that meet stop half-way.':
    '论文给出一个蚂蚁数和两队蚂蚁；我们的默认值将其平分，使两种算法每次迭代都构造 50 条路线。相遇的蚂蚁走到一半就停。',
  "The paper says nothing of its swarm; ours clamps, lifts out of the ground and has the colony's budget.":
    '论文没有说明其粒子群；我们的会截断越界的粒子、把路径抬出地面，并与蚁群预算相同。',
  "Eq. 2 prints the step's length, the words before eq. 1 say distance to the goal; what is improved depends on it.":
    '式 2 印的是步长，式 1 之前的文字说的是到终点的距离；改进与否取决于此。',
}
