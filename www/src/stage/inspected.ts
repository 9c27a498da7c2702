/** Which cell of which panel is looked into. What there is to see is fetched with the first look. */
import type { Cell } from '../maps/edit'
import { inspected } from '../state'
import { lazily } from '../ui/lazily'

export const Inspector = lazily(async () => (await import('../playback')).fetchInspector())

/** Looks into cells of one panel. */
export const inspector = (panelId: number) => (cell: Cell) => {
  inspected.value = { panelId, cell, level: null }
}

export const isInspected = (panelId: number) => inspected.value?.panelId === panelId
