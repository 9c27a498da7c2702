/** The rest of the engine: the planners a first visit does without, fetched when there is time, or at once when one is asked for. */

import type { RunSummary } from '@pkg/formicarium'
import { batch, effect } from '@preact/signals'
import { tools } from '../engine/tools'
import { catalog, type Phase, panels, phase, rest } from './store'

/** A browser that cannot tell when it is idle gets this long instead. */
const SOON_MS = 1500

let underWay: Promise<void> | null = null

/** Where nobody has asked for it: a failure is not repeated until somebody does. */
export function fetchUnasked(): void {
  if (rest.peek() === 'absent') void fetchRest()
}

/** May be called at any time, and again after it has failed; resolves when it is known whether it came. */
export function fetchRest(): Promise<void> {
  if (rest.peek() === 'here') return Promise.resolve()
  underWay ??= fetchNow().finally(() => {
    underWay = null
  })
  return underWay
}

async function fetchNow(): Promise<void> {
  rest.value = 'fetching'
  try {
    const whole = await tools.wholeCatalog()
    batch(() => {
      catalog.value = whole
      rest.value = 'here'
    })
  } catch {
    rest.value = 'failed'
  }
}

/** Once a run moves, or rests because the reader wants it so: nothing competes with what a visitor waits for. */
export function fetchRestWhenIdle(): void {
  let asked = false
  effect(() => {
    if (asked || !panels.value.some(({ live }) => settled(live.value.summary, phase.value))) return
    asked = true
    if ('requestIdleCallback' in window) requestIdleCallback(fetchUnasked)
    else setTimeout(fetchUnasked, SOON_MS)
  })
}

function settled(summary: RunSummary | null, now: Phase): boolean {
  if (summary === null) return false
  return now !== 'running' || summary.effort.cell_expansions + summary.effort.ant_moves > 0
}
