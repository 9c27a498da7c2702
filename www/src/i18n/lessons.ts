/** `t` for the gallery of lessons, whose words are fetched with it. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enLessons } from './en/lessons'

const english = { lessons: enLessons }

export type LessonsKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: LessonsKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addLessonsWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { lessons: (await import('./zh_cn/lessons')).zhCNLessons }
}
