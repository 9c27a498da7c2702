/** What the session carries for a lesson, changed part by part. */
import type { Lesson } from '../model/lesson'
import { lesson } from '../state'

type Changes = { [Part in keyof Lesson]: Lesson[Part] | null }

/** Null takes a part away; a lesson without parts is none, and links are as they were. */
export function changeLesson(changes: Changes): void {
  const entries = Object.entries({ ...lesson.peek(), ...changes }).filter(
    ([, part]) => part !== null,
  )
  lesson.value = entries.length > 0 ? (Object.fromEntries(entries) as Lesson) : null
}
