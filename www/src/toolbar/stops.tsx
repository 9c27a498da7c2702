import { lesson, wholeEngine } from '../state'
import { lazyParts } from '../state/lazy_parts'
import { lazily } from '../ui/lazily'

const LessonTools = lazily(() => lazyParts.lesson('tools'))

/** Stops and lessons: their place is kept free until they come, with the whole engine or with a session that has some. */
export function Stops() {
  const wanted = wholeEngine.value === 'here' || lesson.value
  return <span class="lesson-place">{wanted && <LessonTools />}</span>
}
