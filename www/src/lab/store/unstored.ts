/** Comparisons that the browser refused to store: kept as long as the page is open, and leaving it asks. */
import type { KeptRun } from '../../model/comparison_calls'
import { embedding } from '../../state/embedding'
import { askBeforeLeaving } from '../../state/leaving'
import type { StoredComparison } from './browser_storage'

const kept = new Map<string, { comparison: StoredComparison; runs: KeptRun[] }>()

/** From now on its runs are in this page alone. */
export function noteUnstored(id: string): void {
  // Who leaves a page is not asked about the frames in it.
  if (!embedding) askBeforeLeaving(`comparison ${id}`, true)
}

/** They have been saved elsewhere. */
export function noteSaved(id: string): void {
  askBeforeLeaving(`comparison ${id}`, false)
}

export function keepUnstored(comparison: StoredComparison, runs: KeptRun[]): void {
  kept.set(comparison.id, { comparison, runs })
}

export const unstored = (id: string) => kept.get(id) ?? null

export function dropUnstored(id: string): void {
  kept.delete(id)
  noteSaved(id)
}
