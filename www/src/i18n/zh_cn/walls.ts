import type { DictionaryShape } from '../dictionary_shape'
import type { enWalls } from '../en/walls'

export const zhCNWalls: DictionaryShape<typeof enWalls> = {
  label: '运行中改动墙体时',
  anew: '重新开始',
  keep: '保留信息素',
  keepNote:
    '蚁群带着已有的信息素在新地图上继续；搜索算法与群智能算法在新地图上重新开始。一笔画成的算一次改动，在一次迭代结束时生效。',
  anewNote: '所有规划器都在新地图上重新开始。',
  changed: '墙体在本次迭代结束时改动，信息素保留。',
  beginAnew: '在新地图上重新开始：{{planners}}',
  most: '一次运行中墙体最多改变 {{most}} 次：地图保持原样。',
  ahead: '此会话中还有尚未发生的墙体改动，地图保持原样。',
  aheadHint: '请运行到改动全部完成，或在最终的地图上重新开始。',
  replayed_other: '此会话运行时墙体会改动 {{count}} 次。',
  replayedHint: '每个规划器都在为它记录的那次迭代之后得到改动。',
  begin: '在此地图上重新开始',
  made_other: '本次运行中墙体改动了 {{count}} 次。',
  failed: '现在无法在运行中改动墙体，运行已重新开始。',
}
