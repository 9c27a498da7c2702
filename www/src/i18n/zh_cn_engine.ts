/** Chinese for what the engine says: planners, parameters, options, errors and remarks by key. What is missing stays English. */
export const zhCNEngine = {
  planners: {
    'ant-system': {
      name: '蚂蚁系统 (AS)',
      summary: '最早的蚁群算法：每只到达的蚂蚁都留下信息素，路径越短留得越多，信息素会挥发。',
    },
    acost: {
      name: '自适应阈值蚁群 (ACOST)',
      summary: '早期禁止概率超过阈值的步，使蚂蚁分散；阈值随迭代升至 1。',
    },
    acomsp: {
      name: '最大转移概率蚁群 (ACOMSP)',
      summary: '每只蚂蚁都走概率最大的一步，并奖励本代最短路径；常常全部走进同一条死路。',
    },
    ship: {
      name: '机舱救援蚁群',
      summary:
        '蚂蚁同时看目标、方向和周围障碍；最优路径增加信息素，最差路径减少信息素（范学兴等 2026，不含其路径优化步骤）。',
    },
    'elitist-ant-system': {
      name: '精英蚂蚁系统 (EAS)',
      summary: '在蚂蚁系统上，每次迭代都给至今最优路径额外的信息素，如同精英蚂蚁又走了一遍。',
    },
    'rank-based-ant-system': {
      name: '基于排序的蚂蚁系统 (ASrank)',
      summary: '每次迭代只有最好的几只蚂蚁留下信息素，名次越前留得越多，至今最优路径留得最多。',
    },
    'max-min-ant-system': {
      name: '最大最小蚂蚁系统 (MMAS)',
      summary:
        '每次迭代只有最优路径留下信息素，信息素保持在上下限之间，因此任何路都不会被完全放弃。',
    },
    'ant-colony-system': {
      name: '蚁群系统 (ACS)',
      summary: '蚂蚁多半选最好的一步，边走边减弱走过的信息素，只有至今最优路径得到加强。',
    },
    dijkstra: {
      name: 'Dijkstra',
      summary: '按代价一圈一圈向外探索，直到抵达终点；路径总是最短。',
    },
    astar: {
      name: 'A*',
      summary: '按已走代价加剩余代价的下界探索；路径总是最短，通常扩展更少的格子。',
    },
  },
  params: {
    ants: '每次迭代中构造路径的蚂蚁数',
    iterations: '蚁群停止前的迭代次数',
    alpha: '选择下一步时信息素 τ 的权重',
    beta: '选择下一步时启发信息 η 的权重',
    rho: '挥发率：每次迭代中信息素消失的部分',
    deposit: '到达的蚂蚁在每一步上留下 Q / 长度',
    initial_trail: '第一次迭代之前每一步上的信息素',
    heuristic: '蚂蚁对一步所能看到的信息',
    move_deposit: '每走一步，蚂蚁在这一步上留下 Q1 / 已走长度',
    path_deposit: '本代最短路径的每一步得到 Q2 / 长度',
    rule: '蚂蚁如何选择下一步',
    reading: '论文公式与其正文不一致之处如何取舍',
    goal_distance: '蚂蚁看终点本身时，代替距离 0 的值',
    update: '采用论文两个信息素更新公式中的哪一个',
    goal_pull: '目标引力的强度',
    omega_min: '开始时目标引力的权重',
    omega_max: '结束时目标引力的权重',
    obstacle_push: '格子周围障碍的排斥强度',
    k_best: '附加信息素中本代最优路径的权重',
    k_worst: '附加信息素中本代最差路径的权重',
    trail_min: '削弱最差路径时信息素不低于此值',
    dead_end: '没有可走的邻格时蚂蚁怎么做',
    move_limit: '蚂蚁走满 (宽 + 高) 的这么多倍后放弃；0 表示从不',
    stagnation: '这么多次迭代没有更短路径就停止；0 表示从不',
    elitists: '至今最优路径的权重：每次迭代中它被这么多次地留下信息素',
    ranks: '至今最优路径的权重；名次为 r 的蚂蚁权重为 w − r，因此有 w − 1 只蚂蚁留下信息素',
    p_best: '信息素收敛后重复最优路径的概率；它决定信息素的下限',
    best_every:
      '迭代次数为它的倍数时由至今最优路径留下信息素，其余由本次迭代的最优路径；0 表示从不',
    restart_after: '这么多次迭代没有更短路径后，所有信息素重新从上限开始；0 表示从不',
    q0: '直接选最好的一步而不抽取的概率',
    xi: '局部挥发率：蚂蚁经过时，该步信息素中被 τ0 取代的部分',
  },
  options: {
    detour: '绕行量',
    goal: '到终点的距离',
    step: '步长',
    backtrack: '回退',
    threshold: '自适应阈值',
    proportional: '轮盘赌',
    repaired: '按正文修正',
    printed: '按印刷公式',
    weighted: '加权更新（式 14）',
    'all-ants': '全体更新（式 12）',
    die: '死亡',
  },
  notices: {
    unreachable: '在此移动规则下，起点与终点之间没有通路。',
    'start-is-goal': '起点与终点是同一格：路径长度为 0。',
    'ends-chosen': '文件没有给出起点和终点：使用 ({{start}}) 与 ({{goal}})。',
    'matrix-one-is-blocked':
      '0 读作空闲，1 读作障碍。若含义相反，请在地图菜单中选择“交换墙与空地”。',
    'map-type': '地图类型为“{{value}}”，按 octile 读取。',
  },
  errors: {
    'out-of-range': {
      message: '{{field}} = {{value}} 超出范围 {{min}} 至 {{max}}',
      hint: '请选择 {{min}} 与 {{max}} 之间的值',
    },
    'wrong-type': { message: '{{field}} 的值 {{value}} 类型不对', hint: '请改正该值' },
    'unknown-planner': { message: '没有规划器“{{value}}”', hint: '可用的有 {{known}}' },
    'start-blocked': {
      message: '起点 ({{x}}, {{y}}) 位于障碍上',
      hint: '移动起点，或清除该处的墙',
    },
    'goal-blocked': { message: '终点 ({{x}}, {{y}}) 位于障碍上', hint: '移动终点，或清除该处的墙' },
    'map-size': {
      message: '不能使用 {{width}} × {{height}} 格的地图',
      hint: '每边 1 到 {{max}} 格',
    },
    'unknown-format': {
      message: '无法识别该文件的格式',
      hint: '可打开 MovingAI .map 与 .scen、0/1 矩阵，以及 JSON 场景',
    },
    'not-text': { message: '该文件不是 UTF-8 文本', hint: '请选择文本格式的地图文件' },
    'no-free-cell': {
      message: '地图没有空闲格',
      hint: '至少清除一格；若 1 表示空闲，请先反转地图',
    },
    'too-large': { message: '文件超出可读取的大小 {{max}}', hint: '请先裁剪或缩小地图' },
    version: {
      message: '格式版本为“{{value}}”，此版本读取“{{expected}}”',
      hint: '请刷新页面后重试',
    },
    'link-foreign': {
      message: '这不是 Formicarium 的分享链接',
      hint: '分享链接的地址后以 #x= 开头；请复制完整链接',
    },
    'link-damaged': {
      message: '链接已损坏',
      hint: '可能缺少一部分；请重新复制完整链接，或索取文件',
    },
    'link-newer': { message: '链接由更新的版本生成', hint: '请刷新页面获取最新版本后再打开' },
    'link-too-large': {
      message: '链接的内容太大',
      hint: '可打开不超过 4096 × 4096 格、六个面板的内容',
    },
    'link-invalid': {
      message: '链接内容无效：{{field}}',
      hint: '它不是由“分享”生成，或被手工改动过',
    },
    'engine-crashed': { message: '引擎已停止', hint: '您绘制的内容没有丢失。重置即可重新启动引擎' },
  },
}
