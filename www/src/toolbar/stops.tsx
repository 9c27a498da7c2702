import { lesson, wholeEngine } from '../state'
import { lazily } from '../ui/lazily'

const LessonTools = lazily(async () => (await import('../lesson')).fetchTools())

/** Stops and lessons: their place is kept free until they come, with the whole engine or with a session that has some. */
export function Stops() {
  const wanted = wholeEngine.value === 'here' || lesson.value !== null
  return <span class="lesson-place">{wanted && <LessonTools />}</span>
}
