/** `t` for the copy of the page that the browser keeps, whose words are fetched with it. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enOffline } from './en/offline'

const english = { offline: enOffline }

export type OfflineKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: OfflineKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addOfflineWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { offline: (await import('./zh_cn/offline')).zhCNOffline }
}
