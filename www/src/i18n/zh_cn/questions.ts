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
  'Elitist potential-field ACO: what each part and each open place does':
    '精英势场蚁群算法：各部分与各未定之处的作用',
  'Elitist potential-field ACO on the ground': '沿地面移动的精英势场蚁群算法',
  "Engine-room ACO on robots' maps: when it arrives": '机器人地图上的机舱蚁群算法：何时到达',
  'A colony of our own against A* and 17 other colonies':
    '我们自己的蚁群，对比 A* 与另外 17 个蚁群',

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
  'Fan, Zhang, Liu, Zhu 2026, Journal of Dalian Maritime University 52(1), 87–98, section 4.3, part 3; doi:10.16411/j.cnki.issn1006-7736.2026.01.009':
    '范学兴、张彬、刘世翔、朱文斌 2026，大连海事大学学报 52(1)，87–98，第 4.3 节第 3 部分；doi:10.16411/j.cnki.issn1006-7736.2026.01.009',

  // What they ask.
  "Do the successors of Ant System find shorter paths than it does, as they do on tours (Dorigo and Stützle 2004, chapter 3), when each constructs 5000 paths? Parameters are the defaults here: the book's where it has them. A question of our own: no size is claimed.":
    '各构造 5000 条路径时，蚂蚁系统的后继算法能否如在旅行商问题上那样（Dorigo 与 Stützle 2004，第 3 章）找到比它更短的路径？参数取此处的默认值：书中给出的取书中的值。这是我们自己的问题：没有所称的大小。',
  "Does the hybrid find shorter paths than its parts, and sooner, with the paper's parameters? The paper's map is a figure, so many maps of ours stand for it, of its size and in its style. The hybrids begin with 50 iterations of fireworks or particles. The paper's curve begins with the ants, and so does the iteration of the best here; constructed paths count both stages. Each claim is asked as we read the paper, as printed, and with an x_min above 0 and a trail of the iteration's best path alone.":
    '采用论文的参数，混合算法能否比其组成部分更快地找到更短的路径？论文的地图只是一张图，因此由我们的多张地图代表，大小与风格相同。混合算法先用烟花或粒子迭代 50 次。论文的曲线从蚂蚁开始，这里的最优所在迭代也是如此；构造的路径数把两个阶段都计入。每项主张分别按我们的理解、按印刷公式，以及取大于 0 的 x_min 且只由本次迭代的最优路径留下信息素来检验。',
  "Does the improved algorithm find shorter paths with fewer turns in fewer iterations than the basic ant colony, with the paper's parameters? The paper's maps are figures, so many maps of ours stand for each, of its size and in its style. Its improved paths are refined by line of sight (section 3.3); so are ours, and length and turns are those of the refined path. The basic colony's are not refined, in the paper neither; so the search is also compared by itself, with both unrefined and with both refined, without a claimed size. Each claim is asked as we read the paper, as printed, and with ρ = 0.8 as the part of a trail that stays.":
    '采用论文的参数，改进算法能否比基本蚁群以更少的迭代找到更短、转弯更少的路径？论文的地图只是图，因此每张由我们的多张地图代表，大小与风格相同。论文的改进路径按视线拉直（第 3.3 节），我们的也是，长度与转弯取自拉直后的路径。基本蚁群的路径不拉直，论文中也是如此；因此还单独比较搜索本身：两者都不拉直，以及两者都拉直，此时没有所称的大小。每项主张分别按我们的理解、按印刷公式，以及以 ρ = 0.8 为保留部分来检验。',
  "Does the improved algorithm find cheaper paths than the basic ant colony and particle swarms, in fewer iterations, with the paper's parameters? By slices, the cost Σ √(1 + Δy² + Δh²) + |h| is what the paper calls length: its numbers are of that scale on the one terrain that is known (see the paper card). The terrains here are ours: made by a seeded generator, several in each of the paper's sizes. Each claim is asked as we read the paper, as printed, and with trails that grow and evaporate at each step.":
    '采用论文的参数，改进算法能否比基本蚁群和粒子群以更少的迭代找到代价更低的路径？按切片移动时，论文所说的长度就是代价 Σ √(1 + Δy² + Δh²) + |h|：在唯一已知的地形上，论文的数字正是这个量级（见论文卡片）。这里的地形是我们的：由给定种子的生成器生成，论文的每种大小各有多张。每项主张分别按我们的理解、按印刷公式，以及以每一步都既增加又挥发的信息素来检验。',
  'What do the parts of the improved algorithm do, and what do the places change that the paper leaves open: the distance in η, how much a level counts, the local rule, the number of directions? On the terrains of the size of table 2.':
    '改进算法的各部分有何作用，论文未定之处又会改变什么：η 中的距离、一层算作多高、局部规则、方向数？在表 2 大小的地形上比较。',
  'Does the improved algorithm find shorter paths than the basic ant colony and particle swarms where one walks on the ground, with 16 moves? A question of our own: the paper moves by slices. The terrains stand for no map of the paper.':
    '沿地面以 16 个方向移动时，改进算法能否比基本蚁群和粒子群找到更短的路径？这是我们自己的问题：论文按切片移动。这些地形不代表论文的任何地图。',
  "Does ACOST find shorter paths than ACOMSP, and in the harder environment than ACO, with the paper's parameters? The paper's environments are figures, so many maps of ours stand for each, of its size and in its style, half of them walked from the other end, as the paper does not say which way; the open ones have fewer obstacles, so that ACOMSP arrives on more of them. In environment I the paper gives ACOST and ACO the same length; nothing is claimed about the two there. Each claim is asked as we read the paper, as printed, and with ants that enter the goal when they are beside it.":
    '采用论文的参数，ACOST 能否找到比 ACOMSP 更短的路径，并在较难的环境中优于 ACO？论文的环境只是图，因此每个由我们的多张地图代表，大小与风格相同；论文没有说明走向，所以其中一半从另一端出发；开阔的一组障碍较少，使 ACOMSP 在更多的地图上能够到达。在环境 I 中，论文给出的 ACOST 与 ACO 长度相同；对这两者在该处没有主张。每项主张分别按我们的理解、按印刷公式，以及让与终点相邻的蚂蚁直接进入终点来检验。',
  "Do the weighted order and the pseudo-random proportional rule give a path of less weight R, with fewer turns and sooner, with the paper's parameters? The paper's walls are a figure, so many maps of ours stand for it; start, fires and their weights give its order table (table 1, figure 4). The table's index, 54.02 and 49.71, is called R in the text, the length of each leg times the weight of its fire, though legs of these lengths cannot weigh that much; so the size of the claim on R is that of the orders, 24.45 to 21.47. Each claim is asked as we read the paper, as printed, and with its index V as the criterion of a path, as its conclusion says.":
    '采用论文的参数，加权次序与伪随机比例规则能否更快地给出权重 R 更小、转弯更少的路径？论文的墙只是一张图，因此由我们的多张地图代表；起点、火源及其权重能得出论文的次序表（表 1，图 4）。表中的综合指标 54.02 与 49.71 在正文中称为 R，即各段长度乘以所到火源的权重，但这样长的路段不可能有这么大的权重；因此关于 R 的主张取两种次序的差别，24.45 至 21.47。每项主张分别按我们的理解、按印刷公式，以及以其指标 V 为路径标准（如其结束语所说）来检验。',
  "Does the improved algorithm arrive earlier than the basic ant colony on maps that a robot's own scans made, in metres and seconds? The paper drives in Gazebo on a map of its own, which is not public: 35.47 m in 464 s against 31.48 m in 410 s. So we ask on three public ROS maps of two places, with a robot's radius, from corner to corner; not on the paper's map, and six ways on three maps are fewer cases than six maps. The speed is the paper's, 35.47 m in 464 s, and turns take no time, as its two printed rates allow; asked again with 2 s a turn, which is ours.":
    '在由机器人自己的扫描得到的地图上，以米与秒计，改进算法是否比基本蚁群更早到达？论文在 Gazebo 中用自己的地图行驶，该地图没有公开：464 秒走 35.47 米，对 410 秒走 31.48 米。因此我们在两处地点的三张公开 ROS 地图上提问，取机器人的半径，沿对角线行驶；这不是论文的地图，而且三张地图上的六条路径作为情形少于六张地图。速度取论文的 464 秒走 35.47 米，转弯不计时，如其印刷的两个速率所允许；再以每次转弯 2 秒提问，这是我们的取值。',
  'A* first: how soon is it at the optimum that our own colony finds, too? Then: does our colony find shorter paths than 17 other colonies of the catalog, by steps on a plane, where each may spend half a million ant moves and cell expansions together, and each was tuned alike? And what is left of that without its parts? 24 maps of six kinds, most of them 64 to 512 cells wide, from MovingAI and of robots; some are pieces of one map, so that they are fewer cases than 24. Each colony runs by the best of the same 42 settings, chosen on other maps (experiments/tuning/own-colony). The engine-room ACO goes without its refinement, which would leave the steps. Left out are the composer, which has no rules of its own, who goes by slices alone, and who joined the catalog later. What is counted is moves and expansions: of the scent the parts, not the cells that are looked at to find them, of which our own colony has all free ones twice. The colonies after fireworks and after particles spend the half million on their first stage, so that no ant of theirs walks.':
    '先看 A*：我们的蚁群也找到的最优路径，它多快就能找到？再问：每个规划器至多花费五十万次蚂蚁移动与格扩展，且各自以同样的方式调参时，我们的蚁群找到的路径在平面上按步移动时是否短于目录中另外 17 个蚁群？去掉各部分之后还剩下什么？六类共 24 张地图，大多宽 64 至 512 格，取自 MovingAI 与机器人地图；有些是同一张地图的部分，因此作为情形少于 24 张。每个蚁群用同样 42 组取值中最好的一组，在另外的地图上选出（experiments/tuning/own-colony）。机舱救援蚁群不拉直路径，否则就不再是按步的路径。不包括自己没有规则的组合蚁群、只按切片移动的蚁群，以及后来加入目录的蚁群。所计的是移动与扩展：气味只计各部分，不计为找出它们而看过的格，我们的蚁群把所有空格看了两遍。先烟花与先粒子群的蚁群把五十万次花在第一阶段，它们的蚂蚁没有走过一步。',

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
  'Drawn by hand.': '手绘。',
  "Nav2's depot, 30.2 m × 15.4 m, in cells of 0.5 m; a robot of 0.22 m, Nav2's own default.":
    'Nav2 的 depot，30.2 米 × 15.4 米，每格 0.5 米；机器人半径 0.22 米，即 Nav2 的默认值。',
  "Nav2's tb3_sandbox, an arena 5 m wide, in cells of 0.1 m; a robot of 0.105 m, half the side of the square that ROBOTIS gives the TurtleBot3 Burger (turtlebot3_navigation).":
    'Nav2 的 tb3_sandbox，宽 5 米的场地，每格 0.1 米；机器人半径 0.105 米，即 ROBOTIS 为 TurtleBot3 Burger 给出的正方形边长的一半（turtlebot3_navigation）。',
  'The same arena, mapped by ROBOTIS (turtlebot3).': '同一场地，由 ROBOTIS 建图（turtlebot3）。',
  'The same in cells of 0.2 m.': '同上，每格 0.2 米。',
  "MovingAI's random512-25-0, a quarter of whose cells are obstacles: three pieces and the whole of it.":
    'MovingAI 的 random512-25-0，四分之一的格是障碍：其中三块与整张。',
  "MovingAI's room-64-64-16, two pieces of 32room_000, and the whole of it.":
    'MovingAI 的 room-64-64-16、32room_000 的两块与其整张。',
  "MovingAI's mazes: two pieces of maze512-8-0, maze-128-128-10, and the whole of maze512-8-0.":
    'MovingAI 的迷宫：maze512-8-0 的两块、maze-128-128-10 与整张 maze512-8-0。',
  'Maps of a game, from MovingAI: den312d, lak303d, arena2 and brc202d, 65 × 81 to 530 × 481 cells.':
    'MovingAI 的游戏地图：den312d、lak303d、arena2 与 brc202d，65 × 81 至 530 × 481 格。',
  "MovingAI's warehouse-10-20-10-2-1, 161 × 63 cells: a piece, the whole, and a piece in cells half and a quarter as wide.":
    'MovingAI 的 warehouse-10-20-10-2-1，161 × 63 格：其中一块、整张，以及格宽为一半与四分之一的一块。',
  "ROS maps: Nav2's depot in coarse and in finer cells, Nav2's tb3_sandbox, and a race track, f1_aut_wide.":
    'ROS 地图：较粗与较细格的 Nav2 depot，Nav2 的 tb3_sandbox，以及赛道 f1_aut_wide。',

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
  'Best-Worst Ant System': '最优最差蚂蚁系统',
  'improved, V as the criterion of a path': '改进，以 V 为路径标准',
  'weighted order, eq. 3 for the legs, V as the criterion of a path':
    '加权次序，路段用式 3，以 V 为路径标准',
  'fireworks, as printed': '烟花，按印刷公式',
  'fireworks, x_min = 0.8': '烟花，x_min = 0.8',
  'improved fireworks, as printed': '改进烟花，按印刷公式',
  'improved fireworks, x_min = 0.8': '改进烟花，x_min = 0.8',
  'particles, then ants; x_min = 0.8, the best path alone leaves trail':
    '先粒子后蚂蚁；x_min = 0.8，仅最优路径留下信息素',
  'fireworks, then ants, as printed': '先烟花后蚂蚁，按印刷公式',
  'fireworks, then ants; x_min = 0.8, the best path alone leaves trail':
    '先烟花后蚂蚁；x_min = 0.8，仅最优路径留下信息素',
  'fireworks, then ants that do not know of them; x_min = 0.8, the best path alone leaves trail':
    '先烟花后蚂蚁，蚂蚁不知道烟花的结果；x_min = 0.8，仅最优路径留下信息素',
  'basic ACO, ρ = 0.8 as the part that stays': '基本蚁群，ρ = 0.8 为保留部分',
  'basic ACO, its path refined as well, ρ = 0.8 as the part that stays':
    '基本蚁群，路径也拉直，ρ = 0.8 为保留部分',
  'improved ACO, ρ = 0.8 as the part that stays': '改进蚁群，ρ = 0.8 为保留部分',
  'improved ACO without refinement, ρ = 0.8 as the part that stays':
    '改进蚁群，不拉直，ρ = 0.8 为保留部分',
  'improved ACO, counting the ants on each path': '改进蚁群，统计每条路径的蚂蚁数',
  'improved ACO, ρ shrinks from iteration to iteration': '改进蚁群，ρ 逐次减小',
  'improved ACO, ρ by the difference of best and worst path':
    '改进蚁群，ρ 随最优与最差路径之差变化',
  'F-RRT*': 'F-RRT*',
  'basic ACO without a local rule, τ0 = 0.01': '基本蚁群，无局部规则，τ0 = 0.01',
  'basic ACO, a level counts 0.2 cells': '基本蚁群，一层算 0.2 格',
  'basic ACO, 8 directions': '基本蚁群，8 个方向',
  'improved ACO without a local rule, τ0 = 0.01': '改进蚁群，无局部规则，τ0 = 0.01',
  'improved ACO, a level counts 0.2 cells in η': '改进蚁群，η 中一层算 0.2 格',
  'improved ACO, a level counts 0.2 cells in η and in the field':
    '改进蚁群，η 与势场中一层算 0.2 格',
  'improved ACO, 8 directions': '改进蚁群，8 个方向',
  'basic ACO, eq. 1–4 as printed': '基本蚁群，式 1–4 按印刷公式',
  'basic ACO, the local rule of Ant Colony System, τ0 = 0.01':
    '基本蚁群，蚁群系统的局部规则，τ0 = 0.01',
  'improved ACO, the local rule of Ant Colony System, τ0 = 0.01':
    '改进蚁群，蚁群系统的局部规则，τ0 = 0.01',
  "the textbook's colony, with the numbers of table 1": '教材的蚁群，取表 1 的数值',
  'Ant Colony System by slices': '按切片的蚁群系统',
  'MAX–MIN Ant System by slices': '按切片的最大最小蚂蚁系统',
  'genetic algorithm': '遗传算法',
  'ACO, as printed': 'ACO，按印刷公式',
  'ACO, the goal is entered when it is beside': 'ACO，与终点相邻时直接进入',
  'ACOMSP, as printed': 'ACOMSP，按印刷公式',
  'ACOMSP, the goal is entered when it is beside': 'ACOMSP，与终点相邻时直接进入',
  'ACOST, the goal is entered when it is beside': 'ACOST，与终点相邻时直接进入',
  'A*': 'A*',
  Formica: '求证蚁群（Formica）',
  'Multi-fire ACO': '多火源蚁群',
  'Engine-room ACO': '机舱救援蚁群',
  'Terrain ACO': '地形蚁群',
  'Elitist potential-field ACO': '精英势场蚁群',
  'Adaptive-threshold ACO': '自适应阈值蚁群（ACOST）',
  'Maximum-probability ACO': '最大转移概率蚁群（ACOMSP）',
  'Indoor adaptive ACO': '室内自适应蚁群（IAACO）',
  'Modified adaptive ACO': '改进自适应蚁群（MAACO）',
  'Improved heuristic ACO': '改进启发机制蚁群（IHMACO）',
  'Fireworks, then ants': '先烟花后蚁群',
  'Particles, then ants': '先粒子群后蚁群',
  'Formica without scent': 'Formica，没有气味',
  'Formica without merging': 'Formica，不合并',
  'Formica with a corridor of one width': 'Formica，走廊宽度不变',
  'Formica without restarts': 'Formica，不重启',
  'Formica without a proof': 'Formica，不证明',
  "Formica's ants alone": 'Formica 的蚂蚁单独',

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
  'shorter paths even than with 200 ants (the paper: the same length)':
    '路径甚至短于 200 只蚂蚁（论文：长度相同）',
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
  'cheaper paths by the first trails of the field': '因势场初始化信息素而代价更低',
  'cheaper paths by the force': '因势场力而代价更低',
  'cheaper paths by the elite': '因精英策略而代价更低',
  'cheaper paths by the second colony': '因第二队蚂蚁而代价更低',
  'ACOMSP converges faster': 'ACOMSP 收敛更快',
  'finds a path where there is one, more often (our question: the paper says that it finds a good one quickly, not how often)':
    '有路可走时更常找到路径（我们的问题：论文说它很快找到较优的路径，没有说多常）',
  'within 5 % of the shortest path after fewer constructed paths':
    '构造更少的路径即达到与最短路径相差 5% 以内',
  'fewer turns by V as the criterion alone': '仅因以 V 为标准转弯更少',
  'fewer turns by V as the criterion alone, eq. 3 for the legs':
    '仅因以 V 为标准转弯更少，路段用式 3',
  'shorter paths than by ants alone': '路径短于单独的蚂蚁',
  'shorter paths than by fireworks alone': '路径短于单独的烟花',
  'converges in fewer iterations of the ants': '蚂蚁收敛所需迭代更少',
  'shorter paths than by ants after particles': '路径短于先粒子后蚂蚁',
  'finds its best after fewer constructed paths than 200 ants, both stages counted':
    '比 200 只蚂蚁构造更少的路径即找到最优，两个阶段都计入',
  'ants alone find shorter paths than fireworks alone': '单独的蚂蚁比单独的烟花路径更短',
  'shorter paths than by ants alone, if ρ = 0.9 is what evaporates (section 2.2)':
    '若 ρ = 0.9 为挥发部分（第 2.2 节），路径短于单独的蚂蚁',
  'within 5 % of the shortest path after fewer constructed paths, by the search alone (our question)':
    '仅就搜索而言，构造更少的路径即达到与最短路径相差 5% 以内（我们的问题）',
  'fewer iterations, counting the ants on each path (steps 3 and 4)':
    '统计每条路径的蚂蚁数时迭代更少（第 3、4 步）',
  'fewer iterations, with ρ = 0.8 as the initial factor (section 4)':
    '以 ρ = 0.8 为初始值时迭代更少（第 4 节）',
  'fewer iterations, with the dynamic non-linear rate (section 3.2)':
    '用动态非线性挥发率时迭代更少（第 3.2 节）',
  'shorter paths than the sampling tree that section 3.3 names (our question)':
    '路径短于第 3.3 节提到的采样树（我们的问题）',
  'cheaper paths, both without a local rule and with τ0 = 0.01':
    '路径代价更低，两者均无局部规则且 τ0 = 0.01',
  'cheaper paths, a level counting 0.2 cells in η': '路径代价更低，η 中一层算 0.2 格',
  'cheaper paths, a level counting 0.2 cells in η and in the field':
    '路径代价更低，η 与势场中一层算 0.2 格',
  'cheaper paths, both with 8 directions': '路径代价更低，两者均为 8 个方向',
  'cheaper paths by 16 directions in place of 8 (section 4.4)':
    '因 16 个方向代替 8 个而代价更低（第 4.4 节）',
  'shorter paths than by particles': '路径短于粒子群',
  'cheaper paths than by particles': '路径代价低于粒子群',
  'fewer iterations than particles': '迭代少于粒子群',
  'within 5 % of the cheapest path after fewer constructed paths (our question)':
    '构造更少的路径即达到与最低代价相差 5% 以内（我们的问题）',
  "cheaper paths than by the textbook's colony with the same ants and iterations (our question)":
    '路径代价低于蚂蚁数与迭代数相同的教材蚁群（我们的问题）',
  'cheaper paths than by Ant Colony System (our question)': '路径代价低于蚁群系统（我们的问题）',
  'cheaper paths than by MAX–MIN Ant System (our question)':
    '路径代价低于最大最小蚂蚁系统（我们的问题）',
  'cheaper paths than by a genetic algorithm (our question: the introduction names one)':
    '路径代价低于遗传算法（我们的问题：其引言提到遗传算法）',
  'shorter paths than by the most probable step': '路径短于取最可能一步的方法',
  'within 5 % of the shortest path after fewer constructed paths (our question)':
    '构造更少的路径即达到与最短路径相差 5% 以内（我们的问题）',
  'earlier arrival': '更早到达',
  'earlier arrival where a turn takes 2 s (our question)': '每次转弯 2 秒时更早到达（我们的问题）',
  "earlier arrival, where the basic ACO's path is refined by the same rule: what the search itself gains":
    '基本蚁群的路径按同一规则拉直时更早到达：搜索本身所得',
  "earlier arrival where a turn takes 2 s and the basic ACO's path is refined by the same rule (our question)":
    '每次转弯 2 秒、基本蚁群的路径按同一规则拉直时更早到达（我们的问题）',
  'earlier arrival in finer cells (our question)': '格子更细时更早到达（我们的问题）',
  'the optimum with less effort': '以更少的计算量达到最优',
  'the optimum in more runs': '更多的运行达到最优',

  // What a reader of the verdicts must know.
  "The refined path may take any angle, the baseline's may not: part of the difference is refinement, which would shorten the baseline's paths as well. The search is also compared by itself.":
    '拉直后的路径可取任意角度，基线的路径不能：差别有一部分来自拉直，它同样会缩短基线的路径。搜索本身另作比较。',
  'Not independent: μ, ω, γ and k are not given in the paper, and their values here were chosen because an earlier trial on public grids showed few iterations with them.':
    '并非独立的检验：论文没有给出 μ、ω、γ 与 k，这里的取值是因为此前在公开栅格地图上的试验用它们迭代较少。',
  'The paper gives one number of ants and two colonies; our default splits it, so that both algorithms construct 50 walks an iteration. Ants that meet stop half-way.':
    '论文给出一个蚂蚁数和两队蚂蚁；我们的默认值将其平分，使两种算法每次迭代都构造 50 条路径。相遇的蚂蚁走到一半就停。',
  "The paper says nothing of its swarm; ours clamps, lifts out of the ground and has the colony's budget.":
    '论文没有说明其粒子群；我们的会截断越界的粒子、把路径抬出地面，并与蚁群预算相同。',
  "Eq. 2 prints the step's length, the words before eq. 1 say distance to the goal; what is improved depends on it.":
    '式 2 印的是步长，式 1 之前的文字说的是到终点的距离；改进与否取决于此。',
  'The size is that of the two orders by straight lines, 24.45 and 21.47 (figure 4): the index of table 2, 54.02 and 49.71, cannot be R.':
    '所称的大小取按直线的两种次序，24.45 与 21.47（图 4）：表 2 的指标 54.02 与 49.71 不可能是 R。',
  '31.48 m are 11.2 % less than 35.47 m.': '31.48 米比 35.47 米少 11.2%。',
  "410 s are 11.6 % less than 464 s; the paper's 12.5 % is of neither number. At one speed and with no time for turns this is the claim about length, in seconds.":
    '410 秒比 464 秒少 11.6%；论文的 12.5% 对两个数都不成立。速度相同、转弯不计时，这就是以秒表示的长度主张。',
  "2 s are ours: the paper's speed is a third of the 0.22 m/s that a TurtleBot3 Burger reaches, and at a third of its 2.84 rad/s a quarter of a turn takes 1.6 s. No size is claimed.":
    '2 秒是我们的取值：论文的速度是 TurtleBot3 Burger 最高 0.22 米/秒的三分之一，以其最高 2.84 弧度/秒的三分之一转四分之一圈需 1.6 秒。没有所称的大小。',
  'In cells of 0.2 m a way has two and a half times as many steps: what the cells, which the paper does not tell, do to the difference.':
    '每格 0.2 米时路径的步数是两倍半：显示格子对差别的作用，论文没有说明格子大小。',
  "Ant moves and cell expansions count alike. A* has then proven it; Formica's effort is without what its proof takes after that. For the shortest path by steps, take A*.":
    '蚂蚁移动与格扩展同样计数。A* 此时已证明最优；Formica 的计算量不含其后证明所花的。只要按步最短的路径，请用 A*。',
  'A* always finds it: more is not possible.': 'A* 总能达到：不可能更多。',

  // Where a publication says of its maps what it says.
  'table 1': '表 1',
  'table 2': '表 2',
  'table 3': '表 3',
  'section 4.3': '第 4.3 节',
  'table 2 and figure 5': '表 2 与图 5',
}
