/** `t` for films, steps and codes of links, whose words are fetched with them. */
import { addWords, type KeyOf, t as tOfPage } from '.'
import { enFilm } from './en/film'
import type { ReadingKey } from './reading'

export type FilmKey = ReadingKey | KeyOf<typeof enFilm>

export const t = tOfPage as (key: FilmKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addFilmWords = () => addWords(enFilm, fetchChinese)

async function fetchChinese(): Promise<object> {
  return (await import('./zh_cn/film')).zhCNFilm
}
