/** A draft outlives a reload of its tab; a new tab begins with what races there. */
import { effect } from '@preact/signals'
import type { StoredDraft } from '../../model/draft'
import { fetchWholeEngine, plannerEntry, view, wholeEngine } from '../../state'
import { storeDraft, storedDraft } from '../store/browser_storage'
import { importedFiles, takeImportedFiles } from '../store/imported_files'
import { newId } from '../store/names'
import { recallInTab, rememberInTab } from '../store/tab_memory'
import { drafted, entries, fillWith, removeEntry, takeRace, waitsToBeFilled } from './draft'

/** Waits for a pause in typing. */
const CALM_MS = 250
const TAB_KEY = 'formicarium.draft'

/** Fills the builder with the draft of this tab, or else with what races. */
export async function restoreDraft(): Promise<void> {
  if (!waitsToBeFilled()) return
  const id = recallInTab(TAB_KEY)
  const kept = id === null ? null : await storedDraft(id).catch(() => null)
  if (!waitsToBeFilled()) return
  if (!kept) return takeRace()
  fillWith(kept)
  takeImportedFiles(kept.files)
  // This version of the page may not know every planner of the draft: the complete catalog tells.
  await fetchWholeEngine()
  if (wholeEngine.peek() !== 'here') return
  for (const { key, planner } of entries.peek()) if (!plannerEntry(planner)) removeEntry(key)
}

/**
 * Stores every change from now on; at once when the builder or the page is left. Where the browser refuses, a reload loses the draft
 * and nothing else.
 */
export function storeDraftChanges(): void {
  let timer = 0
  let waiting: Omit<StoredDraft, 'changed'> | null = null
  const flush = () => {
    clearTimeout(timer)
    const draft = waiting
    waiting = null
    if (!draft) return
    const id = recallInTab(TAB_KEY) ?? newId()
    rememberInTab(TAB_KEY, id)
    void storeDraft(id, { ...draft, changed: Date.now() }).catch(() => {})
  }
  effect(() => {
    const draft = drafted()
    const files = importedFiles.value
    if (!draft) return
    waiting = { ...draft, files }
    clearTimeout(timer)
    timer = window.setTimeout(flush, CALM_MS)
  })
  effect(() => {
    if (view.value !== 'lab') flush()
  })
  addEventListener('pagehide', flush)
}
