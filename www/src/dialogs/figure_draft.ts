/** The lattice and the cells of a figure while they are set right: plain data and pure functions. */
import type { Lattice } from '@pkg/formicarium'
import type { Cell } from '../model/cell'

/** Classes of cells, as the engine numbers them. */
export const MARKS = ['free', 'wall', 'start', 'goal', 'path', 'unsure'] as const
export type Mark = (typeof MARKS)[number]
export const classOf = (mark: Mark) => MARKS.indexOf(mark)
export const markOf = (of: number): Mark => MARKS[of] ?? 'unsure'

export interface Draft {
  lattice: Lattice
  /** What was corrected on this lattice, by cell. */
  edits: ReadonlyMap<number, Mark>
}

/** Another lattice: what was corrected belonged to the cells of the former. */
export const withLattice = (lattice: Lattice): Draft => ({ lattice, edits: new Map() })

/** What the cells are, with what was corrected. */
export function corrected(read: Uint8Array, { edits }: Draft): Uint8Array {
  const classes = read.slice()
  for (const [cell, mark] of edits) classes[cell] = classOf(mark)
  return classes
}

/** Makes cells free or walls. */
export function painted(draft: Draft, cells: number[], mark: 'free' | 'wall'): Draft {
  const edits = new Map(draft.edits)
  for (const cell of cells) edits.set(cell, mark)
  return { ...draft, edits }
}

/** Puts an end on a cell; where it was is free. */
export function ended(
  draft: Draft,
  classes: Uint8Array,
  cell: number,
  end: 'start' | 'goal',
): Draft {
  const edits = new Map(draft.edits)
  const before = classes.indexOf(classOf(end))
  if (before >= 0) edits.set(before, 'free')
  edits.set(cell, end)
  return { ...draft, edits }
}

/** What a press makes of a cell: a wall becomes free, all else a wall. */
export const toggled = (mark: Mark) => (mark === 'wall' ? 'free' : 'wall')

/** How many cells are what, in the order of `MARKS`. */
export function countsOf(classes: Uint8Array): number[] {
  const counts: number[] = MARKS.map(() => 0)
  for (const of of classes) counts[of] = (counts[of] ?? 0) + 1
  return counts
}

/** The next unsure cell in the order of reading, from the first again after the last; −1 if there is none. */
export function nextUnsure(classes: Uint8Array, after: number): number {
  const unsure = classOf('unsure')
  const next = classes.indexOf(unsure, after + 1)
  return next >= 0 ? next : classes.indexOf(unsure)
}

export const cellAt = ([x, y]: Cell, { columns }: Lattice) => y * columns + x
export const placeOf = (cell: number, { columns }: Lattice): Cell => [
  cell % columns,
  Math.floor(cell / columns),
]

/** Cells on the straight way between two, with both. */
export function cellsBetween([x, y]: Cell, [toX, toY]: Cell): Cell[] {
  const steps = Math.max(Math.abs(toX - x), Math.abs(toY - y))
  return Array.from({ length: steps + 1 }, (_, i) => {
    const share = steps === 0 ? 0 : i / steps
    return [Math.round(x + share * (toX - x)), Math.round(y + share * (toY - y))]
  })
}
