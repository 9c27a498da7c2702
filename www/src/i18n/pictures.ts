/** `t` for pictures that leave the page, whose words are fetched with them. */
import { addWords, type KeyOf, t as tOfPage } from '.'
import { enPictures } from './en/pictures'
import type { ReadingKey } from './reading'

export type PictureKey = ReadingKey | KeyOf<typeof enPictures>

export const t = tOfPage as (key: PictureKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addPictureWords = () => addWords(enPictures, fetchChinese)

async function fetchChinese(): Promise<object> {
  return (await import('./zh_cn/pictures')).zhCNPictures
}
