/** `t` for lessons, whose words are fetched with them. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enLesson } from './en/lesson'

const english = { lesson: enLesson }

export type LessonKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: LessonKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addLessonWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { lesson: (await import('./zh_cn/lesson')).zhCNLesson }
}
