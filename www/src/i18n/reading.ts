/** `t` for legends of maps and cursors of charts, whose words are fetched with them. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enReading } from './en/reading'

export type ReadingKey = TextKey | KeyOf<typeof enReading>

export const t = tOfPage as (key: ReadingKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addReadingWords = () => addWords(enReading, fetchChinese)

async function fetchChinese(): Promise<object> {
  return (await import('./zh_cn/reading')).zhCNReading
}
