import type { DictionaryShape } from '../dictionary_shape'
import type { enOffline } from '../en/offline'

export const zhCNOffline: DictionaryShape<typeof enOffline> = {
  title: '没有网络时',
  kept: '本页面已保存在此设备上（{{size}} MB），没有网络也能打开',
  keptHint: '其中不含你绘制的内容。“帮助”（?）中有说明，也可在那里删除。',
  newer: '本页面有新版本可用。',
  use: '使用新版本',
  keep: '将页面保存在此设备上',
  drop: '从此设备上删除',
  sameResults: '在小问题上，所有规划器的结果都与之前相同：此前生成的链接应仍能通过验证。',
  otherResults_other:
    '{{names}}的结果有变化：带有其结果的链接在新版本中会显示“不一致”。在你要求之前，继续使用当前版本。',
  onThisPage_other: '本页面有 {{count}} 个面板受影响。',
  comma: '、',
  states: {
    unknown: '页面尚未检查此设备上是否已有保存。',
    impossible: '此浏览器在这里不保存页面。“分享”中的“保存为网页”可生成一个无需网络的文件。',
    off: '页面未保存在此设备上：打开时需要网络。',
    fetching: '正在将页面保存到此设备…',
    failed: '未能获取页面的全部内容，因此尚未保存；下次访问时会再试。',
    kept: '本页面已保存在此设备上（{{size}} MB），包含所有规划器、地图、卡片和语言，没有网络也能打开。新版本会先存放在此，等你要求时才使用。你绘制和比较的内容不在其中。',
  },
}
