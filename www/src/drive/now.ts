/** The walls at the robot's step. */
import { computed } from '@preact/signals'
import { cellsAfter, movingOf } from '../model/moving'
import { scenario } from '../state'
import { standing } from './drive'

const stepNow = computed(() => standing.value?.last.step ?? 0)

/** How many changes of walls have been made. */
const made = computed(() => {
  const now = scenario.value
  return now ? movingOf(now).changes.filter(({ at_step }) => at_step <= stepNow.value).length : 0
})

/** The very cells of the map until the first change. */
export const cellsNow = computed(() => {
  const now = scenario.value
  return now ? cellsAfter(now, movingOf(now).changes.slice(0, made.value)) : new Uint8Array()
})
