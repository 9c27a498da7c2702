/** `t` for names, notes and what a link looked at, whose words are fetched when one of them is wanted. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enNames } from './en/names'

const english = { names: enNames }

export type NamesKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: NamesKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addNamesWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { names: (await import('./zh_cn/names')).zhCNNames }
}
