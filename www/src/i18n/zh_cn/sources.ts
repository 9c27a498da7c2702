/**
 * Chinese for where the catalog's planners, parameters and presets come from, and for what presets mean: by the English text, because
 * many share one. Authors of Chinese papers and Chinese journals have their Chinese names; other names stay as they are.
 */
export const zhCNSources: Record<string, string> = {
  'Bellman 1957, Dynamic Programming, Princeton University Press':
    'Bellman 1957，Dynamic Programming，Princeton University Press',
  'our own; merging after Blum, Pinacho, López-Ibáñez, Lozano 2016, Comput. Oper. Res. 68, 75–88, doi:10.1016/j.cor.2015.10.014':
    '我们自己的；合并求解依据 Blum、Pinacho、López-Ibáñez、Lozano 2016，Comput. Oper. Res. 68，75–88，doi:10.1016/j.cor.2015.10.014',
  'Blum and Dorigo 2004': 'Blum 与 Dorigo 2004',
  'Blum et al. 2016': 'Blum 等 2016',
  'measured: docs/papers/formica.md': '实测：docs/papers/formica.md',
  'as from cell to cell: docs/papers/formica.md': '同逐格移动：docs/papers/formica.md',
  'Bullnheimer, Hartl, Strauss 1999, Central European J. Operations Research and Economics 7, 25–38':
    'Bullnheimer、Hartl、Strauss 1999，Central European J. Operations Research and Economics 7，25–38',
  'Clerc, Kennedy 2002, IEEE Trans. Evolutionary Computation 6, 58–73, doi:10.1109/4235.985692':
    'Clerc、Kennedy 2002，IEEE Trans. Evolutionary Computation 6，58–73，doi:10.1109/4235.985692',
  'Cordón, Fernández de Viana, Herrera, Moreno 2000, Proc. ANTS 2000, 22–29':
    'Cordón、Fernández de Viana、Herrera、Moreno 2000，Proc. ANTS 2000，22–29',
  'Dijkstra 1959, Numerische Mathematik 1, 269–271, doi:10.1007/BF01386390':
    'Dijkstra 1959，Numerische Mathematik 1，269–271，doi:10.1007/BF01386390',
  'Dorigo and Stützle 2004, box 3.1': 'Dorigo 与 Stützle 2004，框 3.1',
  'Dorigo and Stützle 2004, box 3.1: 2 to 5': 'Dorigo 与 Stützle 2004，框 3.1：2 至 5',
  'Dorigo and Stützle 2004, box 3.1: e = n = m': 'Dorigo 与 Stützle 2004，框 3.1：e = n = m',
  'Dorigo and Stützle 2004, eq. 3.5: 1 / length': 'Dorigo 与 Stützle 2004，式 3.5：1 / 长度',
  'Dorigo and Stützle 2004, eq. 3.8': 'Dorigo 与 Stützle 2004，式 3.8',
  'Dorigo and Stützle 2004, eq. 3.8: 1 / length': 'Dorigo 与 Stützle 2004，式 3.8：1 / 长度',
  'Dorigo, Gambardella 1997': 'Dorigo、Gambardella 1997',
  'Dorigo, Gambardella 1997, IEEE Trans. Evolutionary Computation 1, 53–66, doi:10.1109/4235.585892':
    'Dorigo、Gambardella 1997，IEEE Trans. Evolutionary Computation 1，53–66，doi:10.1109/4235.585892',
  'Dorigo, Maniezzo, Colorni 1996, IEEE Trans. SMC-B 26, 29–41, doi:10.1109/3477.484436':
    'Dorigo、Maniezzo、Colorni 1996，IEEE Trans. SMC-B 26，29–41，doi:10.1109/3477.484436',
  'Fan et al. 2026': '范学兴等 2026',
  'Fan et al. 2026, eq. 10–11': '范学兴等 2026，式 10–11',
  'Fan et al. 2026, eq. 14; its step 4 names eq. 12': '范学兴等 2026，式 14；其第 4 步所指为式 12',
  'Fan et al. 2026, eq. 3 and 9; sibling papers have it stay':
    '范学兴等 2026，式 3 与 9；同类论文中为保留的部分',
  'Fan et al. 2026, eq. 6': '范学兴等 2026，式 6',
  'Fan et al. 2026, eq. 7': '范学兴等 2026，式 7',
  'Fan et al. 2026, eq. 8, 9 and 11': '范学兴等 2026，式 8、9 与 11',
  'Fan et al. 2026, section 3.3; next: its words taken one by one':
    '范学兴等 2026，第 3.3 节；“逐点检查”：逐字照其文字',
  'Fan et al. 2026, sections 3.2 and 4, in words alone': '范学兴等 2026，第 3.2 与 4 节，只有文字',
  'Fan et al. 2026, steps 3 and 4': '范学兴等 2026，第 3 与 4 步',
  'Fan et al. 2026, section 4': '范学兴等 2026，第 4 节',
  'Fan et al. 2026, section 4, where it is called the initial trail':
    '范学兴等 2026，第 4 节，该处称为信息素初始值',
  'Fan, Zhang, Liu, Zhu 2026, J. Dalian Maritime Univ. 52(1), 87–98, doi:10.16411/j.cnki.issn1006-7736.2026.01.009':
    '范学兴、张彬、刘世翔、朱文斌 2026，大连海事大学学报 52(1)，87–98，doi:10.16411/j.cnki.issn1006-7736.2026.01.009',
  'Hart, Nilsson, Raphael 1968, IEEE Trans. Systems Science and Cybernetics 4, 100–107, doi:10.1109/TSSC.1968.300136':
    'Hart、Nilsson、Raphael 1968，IEEE Trans. Systems Science and Cybernetics 4，100–107，doi:10.1109/TSSC.1968.300136',
  'Held, Karp 1962, J. SIAM 10, 196–210, doi:10.1137/0110015, and 1971, Math. Program. 1, 6–25, doi:10.1007/BF01584070; legs by A*':
    'Held、Karp 1962，J. SIAM 10，196–210，doi:10.1137/0110015，以及 1971，Math. Program. 1，6–25，doi:10.1007/BF01584070；路段由 A* 求得',
  'Karaman and Frazzoli 2011, theorem 38: above 1': 'Karaman 与 Frazzoli 2011，定理 38：大于 1',
  'Koenig, Likhachev 2002, AAAI-02, 476–483': 'Koenig、Likhachev 2002，AAAI-02，476–483',
  'Lai, Guo 2014': '赖智铭、郭躬德 2014',
  'Lai, Guo 2014, Ant Colony Optimization Based on Self-Adaption Threshold for Path Planning':
    '赖智铭、郭躬德 2014，基于自适应阈值蚁群算法的路径规划算法',
  'Lai, Guo 2014, as printed': '赖智铭、郭躬德 2014，按印刷公式',
  'Lai, Guo 2014, eq. 4': '赖智铭、郭躬德 2014，式 4',
  'Lai, Guo 2014, section 1, of its ref. 13': '赖智铭、郭躬德 2014，第 1 节，出自其文献 13',
  'Lai, Guo 2014, table 1: ACO': '赖智铭、郭躬德 2014，表 1：ACO',
  'Lai, Guo 2014, table 1: ACOMSP, after Tang, Zhang, Jiang, Zhang 2012, J. Comput. Inf. Syst. 8, 10325–10332':
    '赖智铭、郭躬德 2014，表 1：ACOMSP，依据 Tang、Zhang、Jiang、Zhang 2012，J. Comput. Inf. Syst. 8，10325–10332',
  'Liao et al. 2021; our choice: a cell': 'Liao 等 2021；我们的选择：一格',
  'Liao, Wan, Hua, Ma, Zhu, Qing 2021, Expert Systems with Applications 184, 115457, doi:10.1016/j.eswa.2021.115457':
    'Liao、Wan、Hua、Ma、Zhu、Qing 2021，Expert Systems with Applications 184，115457，doi:10.1016/j.eswa.2021.115457',
  'Nash, Daniel, Koenig, Felner 2007, AAAI-07, 1177–1183; Daniel, Nash, Koenig, Felner 2010, JAIR 39, 533–579, doi:10.1613/jair.2994':
    'Nash、Daniel、Koenig、Felner 2007，AAAI-07，1177–1183；Daniel、Nash、Koenig、Felner 2010，JAIR 39，533–579，doi:10.1613/jair.2994',
  'Shi and Eberhart 1999': 'Shi 与 Eberhart 1999',
  'Shi and Eberhart 1999: v_max = x_max': 'Shi 与 Eberhart 1999：v_max = x_max',
  'Shi, Eberhart 1998, ICEC, 69–73, doi:10.1109/ICEC.1998.699146; 1999, CEC, 1945–1950, doi:10.1109/CEC.1999.785511; named in the terrain paper as what it compares with':
    'Shi、Eberhart 1998，ICEC，69–73，doi:10.1109/ICEC.1998.699146；1999，CEC，1945–1950，doi:10.1109/CEC.1999.785511；地形论文提到的比较对象',
  'Stützle and Hoos 2000; Dorigo and Stützle 2004, box 3.1':
    'Stützle 与 Hoos 2000；Dorigo 与 Stützle 2004，框 3.1',
  'Stützle and Hoos 2000; Dorigo and Stützle 2004, section 3.3.4':
    'Stützle 与 Hoos 2000；Dorigo 与 Stützle 2004，第 3.3.4 节',
  "Stützle's program ACOTSP": 'Stützle 的程序 ACOTSP',
  "Stützle's program ACOTSP, without local search": 'Stützle 的程序 ACOTSP，不带局部搜索',
  'Stützle, Hoos 2000': 'Stützle、Hoos 2000',
  'Stützle, Hoos 2000, Future Generation Computer Systems 16, 889–914, doi:10.1016/S0167-739X(00)00043-1':
    'Stützle、Hoos 2000，Future Generation Computer Systems 16，889–914，doi:10.1016/S0167-739X(00)00043-1',
  'Tan, Zhu 2010, LNCS 6145, 355–364, doi:10.1007/978-3-642-13495-1_44; priorities as in Zhou, Mu, Zhang 2019':
    'Tan、Zhu 2010，LNCS 6145，355–364，doi:10.1007/978-3-642-13495-1_44；优先值同周森鹏等 2019',
  'V(d, r): the fire-fighting paper, equation (10); the search is ours: A* (Hart, Nilsson, Raphael 1968) on (cell, direction)':
    'V(d, r)：灭火机器人论文，式 10；搜索为我们的做法：在（格，方向）上的 A*（Hart、Nilsson、Raphael 1968）',
  'Zhang et al. 2020': '张森等 2020',
  'Zhang, Wang, Sun, Liu, Wu, Liu 2020, Computer Science and Application 10(5), doi:10.12677/CSA.2020.105088':
    '张森、王奔、孙梦亚、刘月锟、武曲、刘秀燕 2020，计算机科学与应用 10(5)，doi:10.12677/CSA.2020.105088',
  'Zhou, Mu, Zhang 2019': '周森鹏等 2019',
  'Zhou, Mu, Zhang 2019 (基于烟花混合蚁群的移动机器人路径规划研究)':
    '周森鹏、穆平安、张仁杰 2019，基于烟花混合蚁群的移动机器人路径规划研究',
  'Zhou, Mu, Zhang 2019 (基于烟花混合蚁群的移动机器人路径规划研究), eq. 1–9':
    '周森鹏、穆平安、张仁杰 2019，基于烟花混合蚁群的移动机器人路径规划研究，式 1–9',
  'Zhou, Mu, Zhang 2019, as printed': '周森鹏等 2019，按印刷公式',
  'Zhou, Mu, Zhang 2019, eq. 12; its step 3: by the best path':
    '周森鹏等 2019，式 12；其第 3 步：按最佳路径',
  'Zhou, Mu, Zhang 2019, eq. 6': '周森鹏等 2019，式 6',
  'Zhou, Mu, Zhang 2019, eq. 6 and step 3': '周森鹏等 2019，式 6 与第 3 步',
  'Zhou, Mu, Zhang 2019, section 1.3.2, step 2': '周森鹏等 2019，第 1.3.2 节，第 2 步',
  'Zhou, Mu, Zhang 2019, section 2.1': '周森鹏等 2019，第 2.1 节',
  'Zhou, Mu, Zhang 2019, section 2.1; eq. 2': '周森鹏等 2019，第 2.1 节；式 2',
  'Zhou, Mu, Zhang 2019, section 2.1; eq. 3': '周森鹏等 2019，第 2.1 节；式 3',
  'Zhou, Mu, Zhang 2019, section 2.2': '周森鹏等 2019，第 2.2 节',
  'Zhou, Mu, Zhang 2019, section 2.2: 0.9, by eq. 11 what stays':
    '周森鹏等 2019，第 2.2 节：0.9，按式 11 为保留的部分',
  'Zhou, Mu, Zhang 2019, section 2.2: of the second stage':
    '周森鹏等 2019，第 2.2 节：第二阶段的次数',
  'Zhou, Mu, Zhang 2019, step 1; above eq. 10: after ants':
    '周森鹏等 2019，第 1 步；式 10 之前的文字：在蚂蚁之后',
  'adaptive-threshold ACO (Lai, Guo 2014)': '自适应阈值蚁群（赖智铭、郭躬德 2014）',
  composition: '组装',
  'composition; Ant System: not refined': '组装；蚂蚁系统：不拉直',
  'composition; Ant System: nothing': '组装；蚂蚁系统：没有这一规则',
  'elitist potential-field ACO in three dimensions': '三维精英势场蚁群',
  'elitist potential-field ACO in three dimensions (Hans Publishers, article 41567)':
    '三维精英势场蚁群（汉斯出版社，文章 41567）',
  'eq. 14': '式 14',
  'eq. 4: 1 / length': '式 4：1 / 长度',
  'eq. 5; our choice: not given': '式 5；我们的选择：论文未给出',
  'eq. 5: length; section 5 takes V of eq. 10 as the criterion':
    '式 5：长度；第 5 节以式 10 的 V 为标准',
  'eq. 6–8': '式 6–8',
  'our reading; eq. 5 is printed with the length': '我们的理解；式 5 印作长度',
  'eq. 9': '式 9',
  'eq. 9: 0.6 to 0.8': '式 9：0.6 至 0.8',
  'fire-fighting paper, eq. 6–7': '灭火机器人论文，式 6–7',
  'fire-fighting robot with several fires (Zhang et al. 2020)':
    '面对多个火源的灭火机器人（张森等 2020）',
  'fireworks and ant-colony hybrid (Zhou, Mu, Zhang 2019)': '烟花混合蚁群（周森鹏等 2019）',
  'measured: 0.8 % of ants lost on large maps, same best':
    '实测：大地图上 0.8% 的蚂蚁因此放弃，最优不变',
  'multi-fire path planning for a fire-fighting robot': '灭火机器人多火源路径规划',
  'named by Zhou, Mu, Zhang 2019': '周森鹏等 2019 提到',
  'named in Zhou, Mu, Zhang 2019 as what it compares with; particle swarm as Shi and Eberhart 1999':
    '周森鹏等 2019 提到的比较对象；粒子群同 Shi 与 Eberhart 1999',
  'our addition': '我们的补充',
  'our choice': '我们的选择',
  'our choice, as the exact tour': '我们的选择，同精确巡回',
  'our addition; the paper has no cap': '我们的补充；论文没有上限',
  'our choice, as in Ant System: eq. 4 divides by 0 at the goal':
    '我们的选择，同蚂蚁系统：式 4 在终点处除以 0',
  'our choice: L of eq. 1 is 1 / 0 at the goal': '我们的选择：式 1 的 L 在终点处为 1 / 0',
  "our choice: as many as the ship paper's colonies have": '我们的选择：与船舶论文的蚁群一样多',
  "our choice: as many as the ship paper's colonies have ants":
    '我们的选择：与船舶论文蚁群的蚂蚁一样多',
  'our choice: as many as the fireworks have': '我们的选择：与烟花算法一样多',
  'our choice: eq. 10 does not say how much; as many as the colony has':
    '我们的选择：式 10 未说明多少；取与蚁群同样的蚂蚁数',
  'our choice: eq. 6 from t = 1, eq. 12 once': '我们的选择：式 6 从 t = 1 起，式 12 只计一次',
  'our choice: eq. 6 names limits, no value is given': '我们的选择：式 6 提到上下限，但未给出数值',
  'our choice: eq. 9 is cut out of the copy that we read': '我们的选择：我们所读的版本中缺少式 9',
  'our choice: eq. 9 is cut; Shi and Eberhart 1999': '我们的选择：式 9 缺失；Shi 与 Eberhart 1999',
  'our choice: no tour to derive it from': '我们的选择：没有可据以推算的巡回',
  'our choice: not given': '我们的选择：论文未给出',
  'our choice: not given; near the ground of the highest place half of the pull':
    '我们的选择：论文未给出；在最高处的地面附近为引力的一半',
  "our choice: not given; of the order of an iteration's deposits, m/L":
    '我们的选择：论文未给出；与一次迭代留下的信息素 m/L 同数量级',
  'our choice: not given; the force then weighs about as much as the distance':
    '我们的选择：论文未给出；这样势场力与距离的作用大致相当',
  'our choice: step 1 gives no value': '我们的选择：第 1 步未给出数值',
  'our choice: the fireworks decode about 40 paths an iteration':
    '我们的选择：烟花算法每次迭代约解码 40 条路径',
  "our choice: the paper's proof needs positive trails": '我们的选择：论文的证明要求信息素为正',
  'our choice; Karaman and Frazzoli 2011: a constant': '我们的选择；Karaman 与 Frazzoli 2011：常数',
  'our choice; papers differ or are silent': '我们的选择；各论文不一致或未说明',
  'our choice; papers: goal or step': '我们的选择；论文：到终点的距离或步长',
  'our choice; the paper: euclidean': '我们的选择；论文：直线距离',
  'our reading: as in the traditional algorithm': '我们的理解：同传统算法',
  'ours: A* (Hart, Nilsson, Raphael 1968) on the graph of all cells in line of sight':
    '我们的做法：在所有互相可见的格构成的图上的 A*（Hart、Nilsson、Raphael 1968）',
  'ours: eq. 4 draws from 0 to A_i, Tan and Zhu 2010 from −A_i to A_i':
    '我们的做法：式 4 在 0 至 A_i 之间抽取，Tan 与 Zhu 2010 在 −A_i 至 A_i 之间',
  'ours: see the paper card': '我们的做法：见论文卡片',
  'ours: what the seed is worth': '我们的问题：引导信息素有多大作用',
  "papers' common value": '论文中的常用值',
  "papers' common value; the book takes m = n cities": '论文中的常用值；书中取 m = n 个城市',
  "rescue robot in a ship's engine room (Fan et al. 2026)": '船舶机舱救援机器人（范学兴等 2026）',
  "rescue robot in a ship's engine room (Fan et al. 2026), without its section 3.3":
    '船舶机舱救援机器人（范学兴等 2026），不含其第 3.3 节',
  'section 3.2, step 4: eq. 3, with η of eq. 8': '第 3.2 节，第 4 步：式 3，η 取自式 8',
  'section 4': '第 4 节',
  'section 4, eq. 4': '第 4 节，式 4',
  'section 4.1': '第 4.1 节',
  'section 4.2': '第 4.2 节',
  'section 4.5, the second eq. 12': '第 4.5 节，第二个式 12',
  'step 3, case 1': '第 3 步，情况 1',
  "step 5; proportional: the paper's ACO": '第 5 步；轮盘赌：论文的 ACO',
  'table 1': '表 1',
  'table 1, eq. 12': '表 1，式 12',
  'table 1, eq. 8': '表 1，式 8',
  'table 1, global': '表 1，全局',
  'table 1, local': '表 1，局部',
  'table 1, the selection threshold': '表 1，选择阈值',
  'table 1; also in eq. 6': '表 1；亦见式 6',
  'table 1; eq. 10 multiplies by what stays, also 0.5': '表 1；式 10 乘以保留的部分，也是 0.5',
  'table 1; that it counts both colonies is our reading': '表 1；把两队都计入是我们的理解',
  'terrain paper, Table 1': '地形论文，表 1',
  "the paper's words; step: its eq. 2": '论文的文字；步长：其式 2',
  'the planners that lend the rules': '提供规则的各规划器',

  // What presets mean.
  'its improved algorithm with V of eq. 10 as the criterion of a path, as its section 5 says; the order by straight lines':
    '其改进算法，并按第 5 节以式 10 的 V 为路径的标准；按直线距离确定次序',
  'as second-reading, but an ant leaves Q/L as eq. 5 is printed: V decides which path is the best, and nothing else':
    '同第二种读法，但蚂蚁按式 5 所印留下 Q/L：V 只决定哪条路径最好',
  'its ρ = 0.8 as the part of every trail that stays, as papers of its kind print it; all else as we read it':
    'ρ = 0.8 取为信息素保留的部分，同印作如此的同类论文；其余同我们的读法',
  'an ant beside the goal enters it: eq. 4 is undefined there, not a reason to bar the step':
    '与终点相邻的蚂蚁直接进入：式 4 在此没有定义，并不是禁止这一步的理由',
  'eq. 11 and 12 reward the shortest path m times': '式 11 与 12 奖励最短路径 m 次',
  'an x_min above 0, so that paths keep nearer to the greedy one; the paper gives no value, 0.8 is ours':
    'x_min 大于 0，路径因此更接近贪婪路径；论文未给出数值，0.8 由我们选取',
  "an x_min above 0 (eq. 6; the paper gives no value, 0.8 is ours), and the iteration's best path alone leaves trail (step 3)":
    'x_min 大于 0（式 6；论文未给出数值，0.8 由我们选取），且只有本次迭代最优路径留下信息素（第 3 步）',
  'basic ACO, repaired: its ρ = 0.3 evaporates (0.7 stays), as its text says; Q is not given, 1':
    '基本蚁群，按正文修正：ρ = 0.3 为挥发部分（保留 0.7），与正文相同；Q 未给出，取 1',
  'basic ACO, as printed in its eq. 4: ρ = 0.3 multiplies what stays, so 0.7 leaves':
    '基本蚁群，按印刷的式 4：ρ = 0.3 为保留部分，即挥发 0.7',
  "basic ACO, eq. 1–5, repaired: η = 1/distance to the goal (printed is the step's length: choose step)":
    '基本蚁群，式 1–5，经修正：η = 1/到终点的距离（印刷为步长：可选“步长”）',
  'basic ACO, eq. 1–4, on a plane: η = 1/step length, global evaporation 0.2':
    '基本蚁群，式 1–4，在平面上：η = 1/步长，全局挥发 0.2',
  "its parameters with Ant System's deposit at the end of the iteration (the paper also deposits after every move); half the trail stays":
    '取其参数，但同蚂蚁系统在迭代结束时留下信息素（论文每走一步也留下）；信息素保留一半',
  'basic ACO, eq. 11–12: its ρ = 0.5 is what stays, so 0.5 leaves; backtracking at dead ends':
    '基本蚁群，式 11–12：ρ = 0.5 为保留部分，即挥发 0.5；遇死胡同回退',
  'its improved algorithm, repaired: the order by straight lines, ρ = 0.3 leaves':
    '其改进算法，经修正：按直线距离确定次序，ρ = 0.3 为挥发部分',
  'its own baseline: shortest order by straight lines, random proportional rule on both levels':
    '论文自己的基线：按直线距离的最短次序，次序与路段都用随机比例规则',
  'its improved algorithm as printed: the order by straight lines, ρ = 0.3 stays (eq. 4)':
    '其改进算法，按印刷公式：按直线距离确定次序，ρ = 0.3 为保留部分（式 4）',
  'everything literally: eq. 7 and 8 as printed, eq. 12 for the update, as its step 4 says, and section 3.3 node by node':
    '一切照字面：式 7 与 8 按印刷，按第 4 步所说以式 12 更新，第 3.3 节逐点检查',
  'the search alone: the best path stays cell by cell, to be compared with planners that do not refine':
    '只有搜索：最优路径保持逐格，便于与不拉直的规划器比较',
  'its table 1, which is headed EPF-ACO, and η = 1/distance to the goal, as its text has it':
    '其表 1（标题为 EPF-ACO），η = 1/到终点的距离，按其正文',
  'eq. 1–4 and nothing else: η = 1/step length, every step by its probability, evaporation at the end of the iteration alone':
    '只有式 1–4：η = 1/步长，每一步都按概率抽取，只在迭代结束时挥发',
  'its method with its table 1, repaired where the print does not do what its text says':
    '其方法与表 1，印刷与正文不符之处按正文修正',
  'everything literally: the pull grows with the distance, "or" in eq. 13, no time in the exponent, η = 1/step length':
    '一切照字面：引力随距离增大，式 13 取“或”，指数中没有时间，η = 1/步长',
  "the paper's classic ACO: every step by its probability, Q1 after each move, no reward of the shortest path":
    '论文的经典 ACO：每一步都按概率抽取，每走一步留下 Q1，不奖励最短路径',
  't from 0, so that the first iteration walks uniformly; eq. 11 and 12 reward the shortest path m times':
    't 从 0 起，因此第一次迭代均匀抽取；式 11 与 12 奖励最短路径 m 次',
  'eq. 4 literally: an explosion only ever adds to a priority': '式 4 照字面：爆炸只会增大优先值',
  "50 particles and 100 iterations, the colony's numbers: our reading, the table names no particle; the rest stays":
    '50 个粒子、100 次迭代，同蚁群的数目：我们的理解，表中未提粒子；其余不变',
  'the weights of the constricted swarm for φ = 4.1: w = 0.72984, c1 = c2 = 1.49618':
    '收缩因子粒子群在 φ = 4.1 时的权重：w = 0.72984，c1 = c2 = 1.49618',
  '0.9 is what leaves, as its section 2.2 calls it, against its eq. 11':
    '0.9 为挥发部分，按其第 2.2 节的说法，与其式 11 不同',
  'the same budget and the same colony, but the path of the fireworks leaves no trail':
    '预算与蚁群相同，但烟花算法的路径不留信息素',
  'all rules of MAX–MIN Ant System: the same runs': '全用最大最小蚂蚁系统的规则：运行相同',
  'all rules of Ant Colony System: the same runs': '全用蚁群系统的规则：运行相同',
  'all rules of the multi-fire ACO: the same runs': '全用多火源蚁群的规则：运行相同',
  'all rules of the engine-room ACO: the same runs': '全用机舱救援蚁群的规则：运行相同',
  'all rules of ACOST: the same runs': '全用 ACOST 的规则：运行相同',
  'all rules of ACOMSP: the same runs': '全用 ACOMSP 的规则：运行相同',
  'all rules of the fireworks hybrid: the same runs': '全用先烟花后蚁群的规则：运行相同',
  'all rules of the particle hybrid: the same runs': '全用先粒子群后蚁群的规则：运行相同',
  'Wu, Huang, Cui et al. 2023, Expert Syst. Appl. 215, 119410, doi:10.1016/j.eswa.2022.119410, after two reproductions':
    'Wu、Huang、Cui 等 2023，Expert Syst. Appl. 215，119410，doi:10.1016/j.eswa.2022.119410，按两个复现',
  'reproductions A and B of MAACO': 'MAACO 的复现 A 与 B',
  'reproduction A of MAACO': 'MAACO 的复现 A',
  'reproduction B of MAACO': 'MAACO 的复现 B',
  'reproduction A of MAACO; B: 0.1': 'MAACO 的复现 A；B：0.1',
  'reproduction A of MAACO; B: of the cell entered': 'MAACO 的复现 A；B：按进入的格',
  'reproduction A of MAACO; B: start to goal': 'MAACO 的复现 A；B：从起点到终点',
  'reproduction A of MAACO, where the paper gives none; B: 0.9':
    'MAACO 的复现 A，论文未给出；B：0.9',
  'reproduction B of MAACO; A: walked, earlier the step':
    'MAACO 的复现 B；A：已走的路，更早为这一步',
  'reproduction A of MAACO; B: grows': 'MAACO 的复现 A；B：平稳上升',
  'reproduction A of MAACO; B: max-min': 'MAACO 的复现 A；B：最大最小',
  "the other reproduction's rules and numbers: start trails of the cell entered, steps by the way from start to goal, q0 that grows evenly, MAX–MIN limits":
    '另一个复现的规则与数值：初始信息素按进入的格，步按起点到终点的方向，q0 平稳上升，最大最小上下限',
  'Miao, Chen, Yan et al. 2021, Comput. Ind. Eng. 156, 107230, doi:10.1016/j.cie.2021.107230, after a reproduction':
    'Miao、Chen、Yan 等 2021，Comput. Ind. Eng. 156，107230，doi:10.1016/j.cie.2021.107230，按一个复现',
  'Miao, Chen, Yan et al. 2021, as its reproduction quotes it':
    'Miao、Chen、Yan 等 2021，按其复现所引',
  'reproduction of IAACO': 'IAACO 的复现',
  'reproduction of IAACO: 1/cos φ': 'IAACO 的复现：1/cos φ',
  'reproduction of IAACO: Q': 'IAACO 的复现：Q',
  'μ = |y_j − y_G| / d_jG, as the last form of its formula says':
    'μ = |y_j − y_G| / d_jG，按其公式的最后一种形式',
  'Liu, Wu, Xiao et al. 2023, Knowl.-Based Syst. 271, 110540, doi:10.1016/j.knosys.2023.110540, after a reproduction':
    'Liu、Wu、Xiao 等 2023，Knowl.-Based Syst. 271，110540，doi:10.1016/j.knosys.2023.110540，按一个复现',
  'reproduction of IHMACO': 'IHMACO 的复现',
  'Li, Wang, Cai, Ma, Tan 2022, IEEE Trans. Autom. Sci. Eng., ieeexplore.ieee.org/document/9919849, after two reproductions':
    'Li、Wang、Cai、Ma、Tan 2022，IEEE Trans. Autom. Sci. Eng.，ieeexplore.ieee.org/document/9919849，按两个复现',
  'reproductions A and B of TDI-MSACO': 'TDI-MSACO 的复现 A 与 B',
  'reproduction B of TDI-MSACO': 'TDI-MSACO 的复现 B',
  'reproduction A of TDI-MSACO; B: 20': 'TDI-MSACO 的复现 A；B：20',
  'reproduction A of TDI-MSACO; B: 1': 'TDI-MSACO 的复现 A；B：1',
  'reproduction A of TDI-MSACO; B: 7': 'TDI-MSACO 的复现 A；B：7',
  'reproductions A and B of TDI-MSACO; abstract: 2 or 3': 'TDI-MSACO 的复现 A 与 B；摘要：2 或 3',
  'as Ant System; reproductions A and B of TDI-MSACO: false':
    '与蚂蚁系统相同；TDI-MSACO 的复现 A 与 B：false',
  'our choice; reproductions A and B of TDI-MSACO divide by 0':
    '我们的选择；TDI-MSACO 的复现 A 与 B 除以 0',
  'our choice; reproductions A and B of TDI-MSACO have none':
    '我们的选择；TDI-MSACO 的复现 A 与 B 中没有死胡同',
  '20 ants, α = 1 and β = 7, as reproduction B has them; the rest stays':
    '20 只蚂蚁，α = 1，β = 7，与复现 B 相同；其余不变',
  'our choice; the reproduction lets it walk on with its way cleared':
    '我们的选择；复现中蚂蚁清空所走的路后继续走',
  'Shi, Wang, Yu, Hu 2011, 30 case studies of intelligent algorithms in MATLAB (in Chinese), Beihang University Press: its program on three dimensions':
    '史峰、王辉、郁磊、胡斐 2011，MATLAB智能算法30个案例分析，北京航空航天大学出版社：其三维路径规划程序',
  "the textbook's program": '教材的程序',
  "the textbook's program: decr, its words; 0.5 is what runs":
    '教材的程序：按其文字取 decr；实际运行的是 0.5',
  'the program as it runs: half of a trail leaves one column beyond the place entered, the distance left by the row before the step':
    '照程序实际运行：信息素在所到位置的前一列处减半，剩余距离按走这一步之前的行计',
  '50 ants, 100 iterations, α = 1 and β = 7, the numbers of the colonies that it is compared with; the rest stays':
    '50 只蚂蚁、100 次迭代、α = 1、β = 7，即与之比较的蚁群的数值；其余不变',
  "ours: see the planner's file": '我们的理解：见该规划器的文件',
  "our choice: not given; the textbook's program 0.2": '我们的选择：论文未给出；教材的程序为 0.2',
  'section 4.4: 16 directions in place of 8': '第 4.4 节：以 16 方向代替 8 方向',
  'ours: eq. 3 and the words before it; acs: Dorigo and Gambardella 1997':
    '我们的理解：式 3 及其前的文字；acs：Dorigo 与 Gambardella 1997',
  "the paper's words before eq. 3 and table 1; Dorigo, Gambardella 1997":
    '论文式 3 之前的文字与表 1；Dorigo、Gambardella 1997',
  "trails grow and evaporate at each step, by Ant Colony System's local rule with τ0 = 0.01; else as we read it":
    '信息素在每一步增加和挥发，按蚁群系统的局部规则，τ0 = 0.01；其余按我们的理解',
  'Dorigo and Gambardella 1997: 1/d_ij, here by cost':
    'Dorigo 与 Gambardella 1997：1/d_ij，此处按代价',
  'Stützle and Hoos 2000: 1/d_ij, here by cost': 'Stützle 与 Hoos 2000：1/d_ij，此处按代价',
  'our choice: as many as the terrain paper has ants': '我们的选择：与地形论文的蚂蚁一样多',
  'Goldberg and Deb 1991: binary tournament': 'Goldberg 与 Deb 1991：二元锦标赛',
  'our choice: no paper gives it': '我们的选择：没有论文给出',
  'Eshelman and Schaffer 1993; Syswerda 1989': 'Eshelman 与 Schaffer 1993；Syswerda 1989',
  'Eshelman and Schaffer 1993: BLX-0.5': 'Eshelman 与 Schaffer 1993：BLX-0.5',
  'our choice: one, as is usual; no paper gives it': '我们的选择：照惯例为一个；没有论文给出',
  'De Jong 1975, in Goldberg 1989': 'De Jong 1975，见 Goldberg 1989',
  'our choice: as many as the terrain paper has': '我们的选择：与地形论文一样多',
  "Goldberg 1989, Genetic Algorithms in Search, Optimization, and Machine Learning, Addison-Wesley; Eshelman, Schaffer 1993, FOGA 2, 187–202, doi:10.1016/B978-0-08-094832-4.50018-0; named in the terrain paper's introduction":
    'Goldberg 1989，Genetic Algorithms in Search, Optimization, and Machine Learning，Addison-Wesley；Eshelman、Schaffer 1993，FOGA 2，187–202，doi:10.1016/B978-0-08-094832-4.50018-0；地形论文的引言提到',
  'Syswerda 1989, ICGA, 2–9': 'Syswerda 1989，ICGA，2–9',
  'uniform crossover in place of BLX-0.5: each number from either parent':
    '以均匀交叉代替 BLX-0.5：每个数值取自任一亲代',
}
