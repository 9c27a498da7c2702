/** A comparison that is being put together outlives a reload of its tab; another tab begins with what races there. */
import { effect } from '@preact/signals'
import { fetchRest, plannerEntry, rest } from '../../state'
import { keptDraft, putDraft } from '../keep'
import { recallInTab, rememberInTab } from '../kept'
import { newId } from '../names'
import { ownFiles, takeOwnFiles } from '../own/files'
import {
  drafted,
  entries,
  type Filling,
  fillWith,
  removeEntry,
  takeRace,
  waitsToBeFilled,
} from './draft'

/** Everything of it, as the browser keeps it. */
export interface KeptDraft extends Filling {
  files: ReturnType<typeof ownFiles.peek>
  /** Milliseconds since 1970. */
  changed: number
}

/** Typing comes in bursts. */
const CALM_MS = 250
const TAB_KEY = 'formicarium.draft'

/** What this tab had begun before it was loaded again, else what races. */
export async function fillOnce(): Promise<void> {
  if (!waitsToBeFilled()) return
  const id = recallInTab(TAB_KEY)
  const kept = id === null ? null : await keptDraft(id).catch(() => null)
  if (!waitsToBeFilled()) return
  if (!kept) return takeRace()
  fillWith(kept)
  takeOwnFiles(kept.files)
  // Another version of the page may not know a planner any more; which ones it knows shows when all have come.
  await fetchRest()
  if (rest.peek() !== 'here') return
  for (const { key, planner } of entries.peek()) if (!plannerEntry(planner)) removeEntry(key)
}

/** Writes down every change from now on. A browser that refuses loses what a reload would have brought back, and no more. */
export function keepDraft(): void {
  let timer = 0
  effect(() => {
    const draft = drafted()
    const files = ownFiles.value
    if (!draft) return
    clearTimeout(timer)
    timer = window.setTimeout(() => {
      const id = recallInTab(TAB_KEY) ?? newId()
      rememberInTab(TAB_KEY, id)
      void putDraft(id, { ...draft, files, changed: Date.now() }).catch(() => {})
    }, CALM_MS)
  })
}
