/** The page's own brush under a pointer. */
import type { Cell } from '../model/cell'
import type { Stroke } from '../model/stroke'
import { applyEdit } from '../state'
import { type Brush, newGesture, stroke } from './brush'

/** Walls, start or goal along the way of a pointer. */
export function brushStroke(brush: Brush, from: Cell): Stroke {
  const gesture = newGesture()
  let last = from
  return {
    go(cell) {
      applyEdit(stroke(brush, last, cell), gesture)
      last = cell
    },
  }
}
