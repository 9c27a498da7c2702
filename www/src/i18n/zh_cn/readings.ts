import type { DictionaryShape } from '../dictionary_shape'
import type { enReadings } from '../en/readings'

/** Chinese of en/readings.ts. */
export const zhCNReadings: DictionaryShape<typeof enReadings> = {
  title: '读法',
  of: '{{name}} 的读法',
  names: {
    printed: '按印刷公式',
    'as-read': '按我们的理解',
    'second-reading': '第二种读法',
  },
  defaults: '默认值：公式的含义以论文自己的文字为准。',
  own: '自选的值：整体上不是任何一种读法。',
  noReading: '这些值整体上不是其中任何一种读法。',
  all: '全部',
  claims: '各种读法下的主张',
  claimsHint:
    '每行是一项主张，每列是论文的一种读法，各自单独判定；效应为相对基线的变化：小于 0 即更少。',
  measure: '衡量标准',
  ofClaim: '{{claim}} · {{reading}}',
}
