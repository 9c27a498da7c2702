/** Finds places for the goals of one map on another. */
import type { Goal, ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from './cell'
import { key, nearest } from './settle_ends'

/**
 * Goals of one map on another that has a start of its own and a place for the first of them: the others keep their place in
 * proportion, as near to it as the start can be left for.
 */
export function settleGoals(
  goals: Goal[],
  from: ScenarioSpec,
  to: { width: number; height: number; cells: Uint8Array; start: Cell; goal: Cell },
): Goal[] {
  const [first, ...others] = goals
  if (!first) return []
  const { width, height, cells, start } = to
  const settled = [{ ...first, at: to.goal }]
  if (others.length === 0) return settled
  const taken = new Set([key(start, width), key(to.goal, width)])
  const reached = reachedFrom(start, width, height, cells)
  for (const goal of others) {
    const wanted: Cell = [
      Math.floor((goal.at[0] / from.width) * width),
      Math.floor((goal.at[1] / from.height) * height),
    ]
    const free = (cell: number) => reached[cell] === 1 && !taken.has(cell)
    const at = nearest(wanted, width, height, free)
    if (at === null) continue
    taken.add(key(at, width))
    settled.push({ ...goal, at })
  }
  return settled
}

/** Cells that straight steps lead to: no movement rule allows less. */
function reachedFrom(start: Cell, width: number, height: number, cells: Uint8Array): Uint8Array {
  const reached = new Uint8Array(cells.length)
  const waiting = [key(start, width)]
  reached[waiting[0] ?? 0] = 1
  const visit = (cell: number) => {
    if (cells[cell] === 1 || reached[cell] === 1) return
    reached[cell] = 1
    waiting.push(cell)
  }
  for (let cell = waiting.pop(); cell !== undefined; cell = waiting.pop()) {
    const x = cell % width
    if (x > 0) visit(cell - 1)
    if (x < width - 1) visit(cell + 1)
    if (cell >= width) visit(cell - width)
    if (cell < (height - 1) * width) visit(cell + width)
  }
  return reached
}
