import type { Phrases } from '../phrases'

/** Fields of a scenario by which errors name what is wrong, and what robots, changes and drives allow there (src/scenario/, src/drive/). */
export const zhCNFields: Phrases = {
  'robot.radius': '机器人半径',
  'robot.inflation': '障碍物附近的代价',
  'robot.inflation.radius': '膨胀半径',
  'robot.inflation.cost_scaling': '代价缩放系数',
  'robot.inflation.multiplier': '代价行进倍数',
  'terrain.slices': '移动方式',
  'drive.tracks': '障碍的轨迹',
  'drive.changes': '墙体的改动',
  'drive.sight': '视野',
  'by slices': '按切片',
  'no cells': '空',

  'give absent: a robot drives from cell to cell': '机器人逐格行驶：请改为沿地表移动',
  'give a list of one goal': '行驶只能有一个目标',
  'give a planner whose paths go from cell to cell': '请选择逐格前进的规划器',
  'give a change of one cell or more': '一次改动至少一格',
  'give a cell that the change does not name twice': '一次改动中每格只能出现一次',
  'give a cell that leaves the robot its room at start and goals':
    '请选择给起点与目标处的机器人留有空间的格子',
  'give a cell of the map': '请选择地图内的格子',
  'give a cell that is free until then': '请选择此前空闲的格子',
  'give a cell that is blocked until then': '请选择此前为障碍的格子',
  'give a cell whose height is known': '请选择有高程的格子',
  'give a list of at most {}': '至多 {} 项',
  'give 0 or a positive number of cells': '请输入 0 或正的格数',
  'give no step before that of the change before it, up to {}': '步数不早于前一次改动，至多 {}',
  'give changes that leave every goal free in the end': '改动之后每个目标都须空闲',
  'give a list of 1 to {} cells': '请给出 1 至 {} 格',
  'give 1 to {} cells a side': '每边 1 至 {} 格',
  'give a step up to {}': '步数至多 {}',
  'give 1 to {} steps': '1 至 {} 步',
  'give beside the cell before it': '请选择与前一格相邻的格子',
  'give a track that does not end on a goal': '轨迹不能止于目标',
}
