/** A press with the tool that selects: on a handle it changes the selection, inside it moves it, elsewhere it begins a new one. */
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import { type Area, areaBetween } from '../model/spans'
import type { Press, Stroke } from '../model/stroke'
import { scenario } from '../state'
import { lay, lift, select, selection, tellLaid, unselect } from './selection'

export function selectStroke(press: Press): Stroke | null {
  const now = scenario.peek()
  const area = selection.peek()
  if (now === null) return null
  const opposite = area && oppositeCorner(area, press)
  if (opposite) return spanning(opposite, now)
  return area && holds(area, press.cell) ? moving(area, press, now) : spanning(press.cell, now)
}

/** A new selection between two corners. A mere click selects a cell, or nothing more where there was a selection. */
function spanning(from: Cell, { spec }: Scenario): Stroke {
  const before = selection.peek()
  let moved = false
  const inside = ([x, y]: Cell): Cell => [clamp(x, spec.width), clamp(y, spec.height)]
  return {
    go(cell) {
      moved ||= cell[0] !== from[0] || cell[1] !== from[1]
      selection.value = areaBetween(from, inside(cell))
    },
    end() {
      const area = selection.peek()
      if (before && !moved) unselect()
      else if (area) select(area)
    },
    drop() {
      selection.value = before
    },
  }
}

function moving(area: Area, { cell: from, ctrlKey, altKey }: Press, now: Scenario): Stroke {
  const taken = lift(now, area, ctrlKey || altKey)
  let moved = false
  const to = ([x, y]: Cell): Cell => [area.x + x - from[0], area.y + y - from[1]]
  return {
    go(cell) {
      moved ||= cell[0] !== from[0] || cell[1] !== from[1]
      if (moved) lay(taken, to(cell))
    },
    end() {
      if (moved) tellLaid('editor.movedTo')
    },
    drop() {
      if (moved) lay(taken, [area.x, area.y])
    },
  }
}

/** Of the corner that a press has met, the one across from it; null when it met none. */
function oppositeCorner({ x, y, width, height }: Area, { at, slack }: Press): Cell | null {
  for (const right of [false, true])
    for (const low of [false, true]) {
      const away = Math.hypot(x + (right ? width : 0) - at[0], y + (low ? height : 0) - at[1])
      // A small selection is moved from everywhere but its outer edge.
      if (away <= Math.min(slack, Math.max(0.5, Math.min(width, height) / 3)))
        return [right ? x : x + width - 1, low ? y : y + height - 1]
    }
  return null
}

const holds = ({ x, y, width, height }: Area, cell: Cell) =>
  cell[0] >= x && cell[1] >= y && cell[0] < x + width && cell[1] < y + height

const clamp = (value: number, size: number) => Math.min(size - 1, Math.max(0, value))
