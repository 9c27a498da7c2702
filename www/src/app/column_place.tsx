/** Where the column stands: its place is kept free until it has been fetched, so that nothing moves when it comes. */
import { effect, signal } from '@preact/signals'
import { columnOpen, columnWidth, soughtPart } from '../state'
import { lazily } from '../ui/lazily'
import { whenAntsWalk } from './when_ants_walk'

const Column = lazily(async () => (await import('../column/column')).Column)

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
  if (!columnOpen.value) return null
  const width = columnWidth.value
  return (
    <div class="column" style={{ '--chosen': width === null ? null : `${width}px` }}>
      {wanted.value && <Column />}
    </div>
  )
}
