/** From an empty page to a running one. */

import { effect, untracked } from '@preact/signals'
import { tools } from '../engine/tools'
import { toEngineError } from '../model/errors'
import { arrival } from './address'
import { embedding } from './embedding'
import { fetchNames, lazyParts } from './lazy_parts'
import { held } from './memory'
import { notifyError } from './notices'
import { watchScenario } from './optimum'
import { admitWaiting, autoplay, openFirstSession, openFragment, verifyWaiting } from './sessions'
import { catalog, engineVersion, startError, wholeEngine } from './store'
import { openStoredSession, storeSessionChanges } from './stored_session'
import { fetchWholeEngineWhenIdle } from './whole_engine'

let watching = false

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
  if (embedding) {
    await openEmbedded()
    return
  }
  if (!(await openFragment(location.hash)) && !(await openStoredSession())) openFirstSession()
  autoplay()
}

/** Nothing that this browser keeps is opened, and no other race in the place of one that cannot be read. */
async function openEmbedded(): Promise<void> {
  const opened = await openFragment(location.hash)
  if (!opened && location.hash.startsWith('#x=')) return
  if (!opened) openFirstSession()
  if (embedding?.has('autoplay')) autoplay()
}

function watch(): void {
  watching = true
  watchScenario()
  if (!embedding) storeSessionChanges()
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
