/** `t` for what explains a result that was sent; its words are fetched when one was. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enAbout } from './en/about'

const english = { about: enAbout }

export type AboutKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: AboutKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addAboutWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { about: (await import('./zh_cn/about')).zhCNAbout }
}
