/** `t` for legends of maps and cursors of charts, whose words are fetched with them. */
import { addWords, type KeyOf } from '.'
import { type ColumnKey, t as tOfPage } from './column'
import { enReading } from './en/reading'

export type ReadingKey = ColumnKey | KeyOf<typeof enReading>

export const t = tOfPage as (key: ReadingKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addReadingWords = () => addWords(enReading, fetchChinese)

async function fetchChinese(): Promise<object> {
  return (await import('./zh_cn/reading')).zhCNReading
}
