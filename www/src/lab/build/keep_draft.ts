/** A comparison that is being put together outlives a reload of its tab; another tab begins with what races there. */
import { effect } from '@preact/signals'
import { fetchWholeEngine, plannerEntry, wholeEngine } from '../../state'
import { importedFiles, takeImportedFiles } from '../store/imported_files'
import { recallInTab, rememberInTab } from '../store/kept'
import { newId } from '../store/names'
import { keptDraft, putDraft } from '../store/shelf'
import { drafted, entries, fillWith, removeEntry, takeRace, waitsToBeFilled } from './draft'

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
  takeImportedFiles(kept.files)
  // Another version of the page may not know a planner any more; which ones it knows shows when all have come.
  await fetchWholeEngine()
  if (wholeEngine.peek() !== 'here') return
  for (const { key, planner } of entries.peek()) if (!plannerEntry(planner)) removeEntry(key)
}

/** Writes down every change from now on. A browser that refuses loses what a reload would have brought back, and no more. */
export function keepDraft(): void {
  let timer = 0
  effect(() => {
    const draft = drafted()
    const files = importedFiles.value
    if (!draft) return
    clearTimeout(timer)
    timer = window.setTimeout(() => {
      const id = recallInTab(TAB_KEY) ?? newId()
      rememberInTab(TAB_KEY, id)
      void putDraft(id, { ...draft, files, changed: Date.now() }).catch(() => {})
    }, CALM_MS)
  })
}
