/** From an empty page to a running one. */

import { effect, untracked } from '@preact/signals'
import { tools } from '../engine/tools'
import { toEngineError } from '../model/errors'
import { arrival } from './address'
import { fetchNames, lazyParts } from './lazy_parts'
import { held } from './memory'
import { notifyError } from './notices'
import { watchScenario } from './optimum'
import { admitWaiting, autoplay, openFirstSession, openFragment, verifyWaiting } from './sessions'
import { catalog, engineVersion, startError, wholeEngine } from './store'
import { openStoredSession, storeSessionChanges } from './stored_session'
import { fetchWholeEngineWhenIdle } from './whole_engine'

let watching = false
let openedBefore = async () => false

/** Has something open before all else: what a page of one file carries. False where it does not. */
export function openBefore(open: () => Promise<boolean>): void {
  openedBefore = open
}

/** May be called again after it failed. */
export async function startPage(): Promise<void> {
  startError.value = null
  try {
    const [planners, version] = await Promise.all([tools.catalog(), tools.version()])
    catalog.value = planners
    engineVersion.value = version
  } catch (error) {
    startError.value = toEngineError(error)
    return
  }
  if (!watching) watch()
  if (await openedBefore()) return
  if (!(await openFragment(location.hash)) && !(await openStoredSession())) openFirstSession()
  autoplay()
}

function watch(): void {
  watching = true
  watchScenario()
  storeSessionChanges()
  fetchWholeEngineWhenIdle()
  effect(() => {
    if (wholeEngine.value !== 'here') return
    untracked(admitWaiting)
    fetchNames().catch(() => {})
  })
  effect(() => {
    if (!held.value) untracked(verifyWaiting)
  })
  effect(() => {
    const came = arrival.value
    if (came && came.from !== came.to)
      lazyParts
        .leftSessions()
        .then((left) => left.changeSession(came))
        .catch(notifyError)
  })
}
