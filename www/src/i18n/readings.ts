/** `t` for the readings of a paper, whose words are fetched with the first part that shows them. */
import { addWords, type KeyOf } from '.'
import { type ColumnKey, t as tOfPage } from './column'
import { enReadings } from './en/readings'

const english = { readings: enReadings }

export type ReadingsKey = ColumnKey | KeyOf<typeof english>

export const t = tOfPage as (key: ReadingsKey, args?: Record<string, unknown>) => string

/** Before anything of them is shown. */
export const addReadingsWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { readings: (await import('./zh_cn/readings')).zhCNReadings }
}
