import type { DictionaryShape } from '../dictionary_shape'
import type { enLabRecorded } from '../en/lab_recorded'

/** Chinese of en/lab_recorded.ts. */
export const zhCNLabRecorded: DictionaryShape<typeof enLabRecorded> = {
  recorded: {
    title: '链接所含内容',
    entry: '参评项',
    count_other: '{{count}} 次运行',
    none: '没有运行',
    noPath: '无路径',
    digest: '摘要 {{digest}}',
    asRecorded: '记录值，未在此验证',
    median: '中位数 {{value}}',
    best: '最好 {{value}}',
    gap: '差距 {{value}}',
    paths: '{{part}} / {{whole}} 找到路径',
    notVerified:
      '这些数字是链接中的记录值，运行尚未在此进行。运行完成后，由摘要判断结果是否相同，并显示此处运行的数字。中位数、最好及中位数的差距只统计找到路径的运行。',
    notInIt:
      '链接不含长度、差距等数字，只含运行次数和每个参评项的运行摘要。在此完成运行后才有数字，届时由摘要判断结果是否相同。文件或图片则含有各次运行，打开即可看到数字。',
    carries: '各参评项在各地图上的中位数、最好、差距和找到路径的运行数的记录值：打开即显示',
  },
}
