/** `t` for the page within another one, and for what makes it so: words that are fetched when one of them is wanted. */
import { addWords, type KeyOf } from '.'
import { type ColumnKey, t as tOfPage } from './column'
import { enEmbed } from './en/embed'

const english = { embed: enEmbed }

export type EmbedKey = ColumnKey | KeyOf<typeof english>

export const t = tOfPage as (key: EmbedKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addEmbedWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { embed: (await import('./zh_cn/embed')).zhCNEmbed }
}
