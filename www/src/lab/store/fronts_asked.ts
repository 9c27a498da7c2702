/** Over which measures runs are traded off. */
import { computed, signal } from '@preact/signals'
import type { FrontQuestion } from '../../model/analysis'
import { openComparison } from './signals'

/** What the reader chose, and of which comparison; null: nothing yet. */
const chosen = signal<{ id: string; asked: FrontQuestion } | null>(null)

/** What is asked of the open comparison: what the reader chose, else what the engine proposes; null where none is open. */
export const frontsAsked = computed<FrontQuestion | null>(() => {
  const open = openComparison.value
  if (!open) return null
  return chosen.value?.id === open.id ? chosen.value.asked : open.outline.fronts
})

export function askFronts(asked: FrontQuestion): void {
  const open = openComparison.peek()
  if (open) chosen.value = { id: open.id, asked }
}
