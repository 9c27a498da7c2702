/** The rest of the engine: the planners a first visit does without, fetched when there is time, or at once when one is asked for. */

import type { RunSummary } from '@pkg/formicarium'
import { batch, effect } from '@preact/signals'
import { tools } from '../engine/tools'
import { catalog, type Phase, panels, phase, rest } from './store'

/** A browser that cannot tell when it is idle gets this long instead. */
const SOON_MS = 1500

/** Fields that would lose what is being typed into them if they were drawn anew. */
const FIELDS = 'input, select, textarea'

let underWay: Promise<void> | null = null
/** Ends the wait for somebody who types: somebody else has asked. */
let hurry = () => {}

/** Where nobody has asked for it: a failure is not repeated until somebody does. */
export function fetchUnasked(): void {
  if (rest.peek() === 'absent') void fetchRest()
  else hurry()
}

/** May be called at any time, and again after it has failed; resolves when it is known whether it came. */
export function fetchRest(): Promise<void> {
  if (rest.peek() === 'here') return Promise.resolve()
  hurry()
  return fetchOnce(() => Promise.resolve())
}

/** What arrives when nobody has asked for it waits until no field has the focus. */
function fetchIdly(): void {
  if (rest.peek() !== 'absent') return
  const asked = new Promise<void>((resolve) => {
    hurry = resolve
  })
  void fetchOnce(() => Promise.race([asked, untilNobodyTypes()]))
}

/** `ready`: when what has come may change the controls on the page. */
function fetchOnce(ready: () => Promise<void>): Promise<void> {
  underWay ??= fetchNow(ready).finally(() => {
    underWay = null
  })
  return underWay
}

async function fetchNow(ready: () => Promise<void>): Promise<void> {
  rest.value = 'fetching'
  try {
    const whole = await tools.wholeCatalog()
    await ready()
    batch(() => {
      catalog.value = whole
      rest.value = 'here'
    })
  } catch {
    rest.value = 'failed'
  }
}

/** Whoever leaves a field has said what they had to say, even if they go on to the next. */
function untilNobodyTypes(): Promise<void> {
  return new Promise((resolve) => {
    if (document.activeElement?.matches(FIELDS))
      addEventListener('focusout', () => resolve(), { once: true })
    else resolve()
  })
}

/** Once a run moves, or rests because the reader wants it so: nothing competes with what a visitor waits for. */
export function fetchRestWhenIdle(): void {
  let asked = false
  effect(() => {
    if (asked || !panels.value.some(({ live }) => settled(live.value.summary, phase.value))) return
    asked = true
    if ('requestIdleCallback' in window) requestIdleCallback(fetchIdly)
    else setTimeout(fetchIdly, SOON_MS)
  })
}

function settled(summary: RunSummary | null, now: Phase): boolean {
  if (summary === null) return false
  return now !== 'running' || summary.effort.cell_expansions + summary.effort.ant_moves > 0
}
