import type { DictionaryShape } from '../dictionary_shape'
import type { enDriving } from '../en/driving'

export const zhCNDriving: DictionaryShape<typeof enDriving> = {
  curve: '平滑曲线',
  off: '关',
  on: '开',
  radius: '最小转弯半径（米）',
  curvature: '最大曲率（1/米）',
  curveHints: {
    off: '按搜索结果显示路径。',
    on: '每条路径上画出一条不碰墙的曲线。0 米：转弯可任意急。搜索不受影响。',
  },
  energy: '能耗',
  perMetre: '每米',
  perRadian: '每转一弧度',
  perMetreUp: '每爬升一米',
  energyHints: {
    off: '有平滑曲线或机器人时才列出能耗：每米 {{metre}}，每转一弧度 {{radian}}，每爬升一米 {{up}}。',
    on: '能耗与这三个数同单位，例如焦耳。搜索不受影响。',
  },
}
