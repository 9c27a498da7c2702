/** Which cell of which panel is looked into. What there is to see is fetched with the first look. */

import type { Signal } from '@preact/signals'
import type { Cell } from '../model/cell'
import { inspected } from '../state'
import { lazyParts } from '../state/lazy_parts'
import { lazily } from '../ui/lazily'
import type { CanvasSize } from './panel_view'

interface Looking {
  panelId: number
  /** Null where nothing can be drawn over the map. */
  size: Signal<CanvasSize> | null
}

export const Inspector = lazily<Looking>(() => lazyParts.inspector())

/** Looks into cells of one panel. */
export const inspector = (panelId: number) => (cell: Cell) => {
  inspected.value = { panelId, cell, level: null }
}

export const isInspected = (panelId: number) => inspected.value?.panelId === panelId
