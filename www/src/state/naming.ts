/** Names that readers give: to the session, its map and its planners. Each is one step to undo, and no run begins again. */
import { LONGEST, noteText, oneLine } from '../model/names'
import type { Caption } from '../model/session'
import { exchange } from './history'
import { commit, noteSwap } from './scenarios'
import { caption, panelById, panels, scenario } from './store'

/** What the reader calls the session, or says of it. Changes of the same gesture (one visit to a field) are undone together. */
export function setCaption(change: Partial<Caption>, gesture?: number): void {
  const now = caption.peek()
  const title = oneLine(change.title ?? now.title, LONGEST.title)
  const note = noteText(change.note ?? now.note)
  if (title === now.title && note === now.note) return
  noteSwap(exchange(caption, { title, note }), gesture)
}

/** Nothing typed: it is called by what it does again. */
export function setLabel(panelId: number, typed: string): void {
  let other = panelById(panelId)?.setup.label ?? null
  const label = oneLine(typed, LONGEST.label) || null
  if (label === other) return
  relabel(panelId, label)
  noteSwap(() => {
    const now = panelById(panelId)?.setup.label ?? null
    relabel(panelId, other)
    other = now
  })
}

function relabel(panelId: number, label: string | null): void {
  panels.value = panels
    .peek()
    .map((panel) => (panel.id === panelId ? { ...panel, setup: { ...panel.setup, label } } : panel))
}

/** False where nothing is left to call it by: it keeps the name it has. */
export function renameMap(typed: string, gesture?: number): boolean {
  const now = scenario.peek()
  const name = oneLine(typed, LONGEST.map)
  if (!now || name === '') return false
  if (name !== now.spec.name) commit({ ...now, spec: { ...now.spec, name } }, gesture)
  return true
}
