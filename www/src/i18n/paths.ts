/** `t` for the formats of paths, whose words are fetched when somebody saves one. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enPaths } from './en/paths'

const english = { paths: enPaths }

export type PathsKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: PathsKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addPathsWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { paths: (await import('./zh_cn/paths')).zhCNPaths }
}
