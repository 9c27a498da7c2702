/** Where the cells of a figure lie, and what dragging a lattice does to it: pure functions in pixels of the picture. */
import type { Lattice } from '@pkg/formicarium'
import type { Cell } from '../model/cell'

export type Place = readonly [x: number, y: number]

/** A corner or the middle of an edge: 0, ½ or 1 of the way along columns and rows. */
export type Handle = readonly [u: 0 | 0.5 | 1, v: 0 | 0.5 | 1]

export const HANDLES: Handle[] = [
  [0, 0],
  [0.5, 0],
  [1, 0],
  [0, 0.5],
  [1, 0.5],
  [0, 1],
  [0.5, 1],
  [1, 1],
]

/** Pixels that a cell has at least, as the engine asks for them. */
const LEAST_CELL = 3
/** Columns and rows of a lattice to begin with. */
const SIDES = 20

/** The place of (u, v) in cells: (0.5, 0.5) is the middle of the first. */
export function placeAt(lattice: Lattice, u: number, v: number): Place {
  const { x0, y0, dx, dy, shear_x, shear_y } = lattice
  return [x0 + u * dx + v * shear_x, y0 + v * dy + u * shear_y]
}

export const handlePlace = (lattice: Lattice, [u, v]: Handle): Place =>
  placeAt(lattice, u * lattice.columns, v * lattice.rows)

/** How far along columns and rows a way leads, in cells. */
function inCells({ dx, dy, shear_x, shear_y }: Lattice, [x, y]: Place): Place {
  const area = dx * dy - shear_x * shear_y
  return [(x * dy - y * shear_x) / area, (y * dx - x * shear_y) / area]
}

/** The cell at a place; null beside the lattice. */
export function cellUnder(lattice: Lattice, [x, y]: Place): Cell | null {
  const [u, v] = inCells(lattice, [x - lattice.x0, y - lattice.y0])
  const inside = u >= 0 && v >= 0 && u < lattice.columns && v < lattice.rows
  return inside ? [Math.floor(u), Math.floor(v)] : null
}

export const moved = (lattice: Lattice, [x, y]: Place): Lattice => ({
  ...lattice,
  x0: lattice.x0 + x,
  y0: lattice.y0 + y,
})

/** The lattice with a corner or an edge dragged so far; what lies opposite stays. */
export function dragged(lattice: Lattice, [u, v]: Handle, by: Place): Lattice {
  const { columns, rows, dx, dy, shear_x, shear_y } = lattice
  const [along, down] = inCells(lattice, by)
  const scale = (at: number, way: number, count: number, cell: number) =>
    at === 0.5 ? 1 : Math.max(LEAST_CELL / cell, 1 + (at === 1 ? way : -way) / count)
  const across = scale(u, along, columns, dx)
  const below = scale(v, down, rows, dy)
  const [fixedX, fixedY] = placeAt(lattice, u === 0 ? columns : 0, v === 0 ? rows : 0)
  const after = {
    ...lattice,
    dx: dx * across,
    shear_y: shear_y * across,
    dy: dy * below,
    shear_x: shear_x * below,
  }
  const [x, y] = placeAt({ ...after, x0: 0, y0: 0 }, u === 0 ? columns : 0, v === 0 ? rows : 0)
  return { ...after, x0: fixedX - x, y0: fixedY - y }
}

/** Another number of columns or rows in the same frame. */
export function divided(lattice: Lattice, columns: number, rows: number): Lattice {
  const across = lattice.columns / columns
  const below = lattice.rows / rows
  return {
    ...lattice,
    columns,
    rows,
    dx: lattice.dx * across,
    shear_y: lattice.shear_y * across,
    dy: lattice.dy * below,
    shear_x: lattice.shear_x * below,
  }
}

/** A lattice over the whole picture, to be set right by hand. */
export function latticeOver(width: number, height: number): Lattice {
  const fitting = (side: number) => Math.max(1, Math.min(SIDES, Math.floor(side / LEAST_CELL)))
  const [columns, rows] = [fitting(width), fitting(height)]
  const [dx, dy] = [width / columns, height / rows]
  return { x0: 0, y0: 0, dx, dy, shear_x: 0, shear_y: 0, columns, rows }
}
