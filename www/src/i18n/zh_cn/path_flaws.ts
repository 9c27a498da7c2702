import type { Phrases } from '../phrases'

/** Why cells are no path on a map, as the engine says it (src/path.rs). */
export const zhCNPathFlaws: Phrases = {
  'the path is empty': '路径是空的',
  'the path begins at ({}, {}), not at the start': '路径从 ({}, {}) 出发，而不是起点',
  'the path ends at ({}, {}), not at the goal': '路径止于 ({}, {})，而不是目标',
  'cell {} of the path lies outside the map': '路径中编号为 {} 的格子在地图之外',
  'cell {} of the path, ({}, {}), is blocked': '路径经过的格子 ({1}, {2}) 是障碍',
  'segment {} of the path, from ({}, {}) to ({}, {}), touches an obstacle':
    '路径从 ({1}, {2}) 到 ({3}, {4}) 的一段碰到障碍',
  'the path misses the goal at ({}, {})': '路径没有经过目标 ({}, {})',
  'step {} of the path leads to a cell that is no neighbour':
    '路径中编号为 {} 的一步所到的格子与前一格不相邻',
  'step {} of the path, from ({}, {}) to ({}, {}), cuts a corner, is too steep or is no allowed move':
    '路径从 ({1}, {2}) 到 ({3}, {4}) 的一步切过墙角、太陡，或不被移动规则允许',
}
