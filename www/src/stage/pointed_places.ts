/** Places on panels' maps that something beside the map points at, such as the elevation profile. */
import { signal } from '@preact/signals'
import type { Cell } from '../model/cell'
import type { Cursor } from './panel_view'

/** By panel id. */
export const pointedPlaces = signal<ReadonlyMap<number, Cell>>(new Map())

/** Drawn like the keyboard's cursor while there is no other. */
export function pointedCell(panelId: number): Cursor | null {
  const cell = pointedPlaces.value.get(panelId)
  return cell ? { cell, byKeys: true } : null
}
