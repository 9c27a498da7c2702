import type { DictionaryShape } from '../dictionary_shape'
import type { enScale } from '../en/scale'

export const zhCNScale: DictionaryShape<typeof enScale> = {
  title: '比例与速度',
  cell: '格边长（米）',
  speed: '速度（米/秒）',
  turn: '每次转弯用时（秒）',
  whole: '地图大小为 {{x}} × {{y}}。',
  time: '行进时间 = 米数 / 速度 + 转弯次数 · 每次转弯用时。',
  unit: '长度单位',
  units: { metres: '米', cells: '格' },
  none: '格边长为 1 米且没有世界坐标的地图没有比例尺，其长度以格为单位。',
  slices: '按切片移动时，长度由格与层构成，因此不以米为单位。',
}
