/** What a tool makes of a press that is under way: one contract for the page's own brush and for tools that are fetched. */
import type { Cell } from './cell'
import type { Point } from './viewpoint'

/** Keys held while a pointer moves. */
export interface HeldKeys {
  shiftKey: boolean
  ctrlKey: boolean
  altKey: boolean
}

/** Where and how a press began. */
export interface Press extends HeldKeys {
  cell: Cell
  /** The same in cells, fractions included. */
  at: Point
  /** Cells that a pointer, or a finger, may miss something small by. */
  slack: number
}

export interface Stroke {
  /** The pointer is over this cell, which may lie outside the map; the first call is for the cell pressed. */
  go(cell: Cell, keys: HeldKeys): void
  /** It was lifted there. */
  end?(): void
  /** A second finger made it a pinch, or the browser took it: what has not been drawn is left out. */
  drop?(): void
}
