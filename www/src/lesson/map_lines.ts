/** Cells as points of a drawing over the map, in CSS pixels. */
import type { Cell } from '../model/cell'
import { type CanvasSize, place } from '../stage/panel_view'

export function pointOn(size: CanvasSize, [x, y]: readonly [number, number]): [number, number] {
  const { scale, originX, originY } = place(size)
  return [(originX + (x + 0.5) * scale) / size.dpr, (originY + (y + 0.5) * scale) / size.dpr]
}

export const lineOn = (size: CanvasSize, cells: readonly Cell[]): string =>
  cells
    .map((cell) =>
      pointOn(size, cell)
        .map((value) => value.toFixed(1))
        .join(),
    )
    .join(' ')

/** The side of a cell. */
export const cellSize = (size: CanvasSize): number => place(size).scale / size.dpr
