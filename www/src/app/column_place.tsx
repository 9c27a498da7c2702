/**
 * What stands beside the maps, or on a compact screen below them: the card of a lesson, and the column, whose place is kept free until
 * it has been fetched, so that nothing moves when it comes.
 */
import { effect, signal } from '@preact/signals'
import {
  columnOpen,
  columnWidth,
  compact,
  focused,
  guide,
  inRelief,
  lessonMode,
  soughtPart,
} from '../state'
import { lazyParts } from '../state/lazy_parts'
import { lazily } from '../ui/lazily'
import { whenAntsWalk } from './when_ants_walk'

const Column = lazily(async () => (await import('../column/column')).Column)
const LessonCard = lazily(() => lazyParts.lesson('cards'))

/** Ants come first, unless somebody seeks something in it. */
const wanted = signal(false)
const want = () => {
  wanted.value = true
}
whenAntsWalk(want)
effect(() => {
  if (soughtPart.value !== null) want()
})

export function ColumnPlace() {
  const open = columnOpen.value
  const card = guide.value !== null || (lessonMode.value !== null && !inRelief.value)
  if (!open && !card) return null
  const width = columnWidth.value
  return (
    <div
      class="side"
      data-alone={!open || compact.value || focused.value !== null}
      style={{ '--chosen': width === null ? null : `${width}px` }}
    >
      {card && <LessonCard />}
      {open && <div class="column">{wanted.value && <Column />}</div>}
    </div>
  )
}
