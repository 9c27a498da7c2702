/** From an empty page to a running one. */

import { effect, untracked } from '@preact/signals'
import { tools } from '../engine/tools'
import { toEngineError } from '../model/errors'
import { canKeep } from '../model/storage'
import { arrival } from './address'
import { embedding } from './embedding'
import { fetchNames, lazyParts } from './lazy_parts'
import { held } from './memory'
import { notifyError } from './notices'
import { watchScenario } from './optimum'
import { canUndo } from './scenarios'
import { admitWaiting, autoplay, openFirstSession, openFragment, verifyWaiting } from './sessions'
import { catalog, engineVersion, startError, wholeEngine } from './store'
import { SESSION_KEY } from './stored_key'
import { fetchWholeEngineOnceOnline, fetchWholeEngineWhenIdle } from './whole_engine'

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
  if (embedding) {
    await openEmbedded()
    return
  }
  if (await openedBefore()) return
  if (!(await openFragment(location.hash)) && !(await openStored())) openFirstSession()
  autoplay()
}

/** Nothing that this browser keeps is opened, and no other race in the place of one that cannot be read. */
async function openEmbedded(): Promise<void> {
  const opened = (await openedBefore()) || (await openFragment(location.hash))
  if (!opened && location.hash.startsWith('#x=')) return
  if (!opened) openFirstSession()
  if (embedding?.has('autoplay')) autoplay()
}

/** Opens what the tab has stored, if it has. */
async function openStored(): Promise<boolean> {
  if (!canKeep()) return false
  try {
    if (sessionStorage.getItem(SESSION_KEY) === null) return false
  } catch {
    return false
  }
  return (await import('./stored_session')).openStoredSession()
}

/** Nothing is there to be stored before: what the whole engine waits for, it waits for too. */
function storeChangesOnceIdle(): void {
  let asked = false
  effect(() => {
    if (asked || (wholeEngine.value === 'absent' && !canUndo.value)) return
    asked = true
    import('./stored_session').then((stored) => stored.storeSessionChanges(), notifyError)
  })
}

function watch(): void {
  watching = true
  watchScenario()
  if (!embedding) storeChangesOnceIdle()
  fetchWholeEngineWhenIdle()
  fetchWholeEngineOnceOnline()
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
