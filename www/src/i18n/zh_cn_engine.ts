/** Chinese for what the engine says: planners, parameters, options, errors by kind. What is missing stays English. */
export const zhCNEngine = {
  planners: {
    'ant-system': {
      name: '蚂蚁系统 (AS)',
      summary: '每只蚂蚁按信息素和距离行走；到达的蚂蚁按 1/长度 释放信息素。',
    },
    astar: { name: 'A*', summary: '按 g + h 扩展格子，直到证明到达终点的路径最短。' },
  },
  params: {},
  options: {},
  presets: {},
  notices: {
    'goal-unreachable': '从起点无法到达终点。',
  },
  errors: {
    'out-of-range': {
      message: '{{field}} = {{value}} 超出范围 {{min}} 至 {{max}}',
      hint: '请选择范围内的值',
    },
    'start-blocked': { message: '起点位于障碍上', hint: '清除该格或移动起点' },
    'goal-blocked': { message: '终点位于障碍上', hint: '清除该格或移动终点' },
  },
}
