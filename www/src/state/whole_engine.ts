/** The whole engine, with the planners that a first visit does without: fetched when there is time, or at once when one is needed. */

import type { RunSummary } from '@pkg/formicarium'
import { effect } from '@preact/signals'
import { tools } from '../engine/tools'
import { anotherTask } from '../model/another_task'
import { catalog, type Phase, panels, phase, wholeEngine } from './store'

/** A browser that cannot tell when it is idle gets this long instead. */
const SOON_MS = 1500
/** One that is never idle does not keep it away for longer. */
const AT_LAST_MS = 5000

/** Fields that would lose what is being typed into them if they were drawn anew. */
const FIELDS = 'input, select, textarea'

let underWay: Promise<void> | null = null
/** Ends the wait for a reader who is typing: the whole engine has been asked for. */
let hurry = () => {}

/** For callers that can do without it: after a failure it is not tried again until somebody asks. */
export function fetchWholeEngineUnasked(): void {
  if (wholeEngine.peek() === 'absent') void fetchWholeEngine()
  else hurry()
}

/** May be called at any time, also after a failure. Resolves when it has arrived or failed. */
export function fetchWholeEngine(): Promise<void> {
  if (wholeEngine.peek() === 'here') return Promise.resolve()
  hurry()
  return fetchOnce(() => Promise.resolve())
}

/** Fetched before anybody has asked, it takes effect only once no field has the focus. */
function fetchIdly(): void {
  if (wholeEngine.peek() !== 'absent') return
  const asked = new Promise<void>((resolve) => {
    hurry = resolve
  })
  void fetchOnce(() => Promise.race([asked, untilNobodyTypes()]))
}

/** `ready` resolves when the new planners may change the controls on the page. */
function fetchOnce(ready: () => Promise<void>): Promise<void> {
  underWay ??= fetchNow(ready).finally(() => {
    underWay = null
  })
  return underWay
}

async function fetchNow(ready: () => Promise<void>): Promise<void> {
  wholeEngine.value = 'fetching'
  try {
    const whole = await tools.wholeCatalog()
    await ready()
    catalog.value = whole
    // What follows from each is much to draw.
    await anotherTask()
    wholeEngine.value = 'here'
  } catch {
    wholeEngine.value = 'failed'
  }
}

/** Leaving a field is enough, even for another one. */
function untilNobodyTypes(): Promise<void> {
  return new Promise((resolve) => {
    if (document.activeElement?.matches(FIELDS))
      addEventListener('focusout', () => resolve(), { once: true })
    else resolve()
  })
}

/** A connection that has come back is an occasion to try again. */
export function fetchWholeEngineOnceOnline(): void {
  addEventListener('online', () => {
    if (wholeEngine.peek() === 'failed') void fetchWholeEngine()
  })
}

/** Waits until a run moves, or is paused on purpose: nothing may compete with what a visitor waits for. */
export function fetchWholeEngineWhenIdle(): void {
  let asked = false
  effect(() => {
    if (asked || !panels.value.some(({ live }) => settled(live.value.summary, phase.value))) return
    asked = true
    if ('requestIdleCallback' in window) requestIdleCallback(fetchIdly, { timeout: AT_LAST_MS })
    else setTimeout(fetchIdly, SOON_MS)
  })
}

function settled(summary: RunSummary | null, now: Phase): boolean {
  if (summary === null) return false
  return now !== 'running' || summary.effort.cell_expansions + summary.effort.ant_moves > 0
}
