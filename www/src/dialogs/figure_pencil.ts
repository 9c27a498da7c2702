/** Corrects the cells of a figure, as far as they have been read. */
import type { Cell } from '../model/cell'
import { cellAt, ended, type Mark, markOf, painted } from './figure_draft'
import type { FigureState } from './figure_state'

export interface Pencil {
  markAt: (cell: Cell) => Mark
  /** Free or walls. Ends that are `passed` over stay. Strokes of the same gesture are undone together. */
  paint: (cells: Cell[], mark: 'free' | 'wall', gesture?: number, passed?: boolean) => void
  putEnd: (cell: Cell, end: 'start' | 'goal', gesture?: number) => void
}

export function pencilFor({ draft, classes, change }: FigureState): Pencil | null {
  if (!draft || !classes) return null
  const indexOf = (cell: Cell) => cellAt(cell, draft.lattice)
  const markAt = (cell: Cell) => markOf(classes[indexOf(cell)] ?? 0)
  const isEnd = (cell: Cell) => markAt(cell) === 'start' || markAt(cell) === 'goal'
  return {
    markAt,
    paint: (cells, mark, gesture, passed = false) => {
      const meant = cells.filter((cell) => !(passed && isEnd(cell)))
      if (meant.some((cell) => markAt(cell) !== mark))
        change(painted(draft, meant.map(indexOf), mark), gesture)
    },
    putEnd: (cell, end, gesture) => {
      if (markAt(cell) !== end) change(ended(draft, classes, indexOf(cell), end), gesture)
    },
  }
}
