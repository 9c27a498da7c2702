/** How fast the runs play: as the reader says; until then, fast enough for the map on show. */
import { ITERATION_SPEED, type Scenario } from '../model/session'
import { speed } from './store'

/** On a larger map ants that walk cell by cell take minutes to arrive. */
const LARGEST_WATCHED_SIDE = 128

let chosenByReader = false
/** The speed a large map has replaced, for when a smaller one is opened. */
let replaced: number | null = null

export function chooseSpeed(index: number): void {
  chosenByReader = true
  speed.value = index
}

export function suitSpeed({ spec }: Scenario): void {
  if (chosenByReader) return
  const large = Math.max(spec.width, spec.height) > LARGEST_WATCHED_SIDE
  if (large && speed.peek() < ITERATION_SPEED) {
    replaced = speed.peek()
    speed.value = ITERATION_SPEED
  } else if (!large && replaced !== null) {
    speed.value = replaced
    replaced = null
  }
}

/** A session brings a speed of its own. */
export function setSpeedOfSession(index: number): void {
  replaced = null
  speed.value = index
}
