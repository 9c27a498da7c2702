/** Edits of a scenario, as pure functions: the same object comes back when an edit changes nothing. */

import type { Cell } from './cell'
import { changeGoal, type GoalChange, placeGoal, removeGoal, takenCells } from './goals'
import type { Scenario } from './session'
import { hasNoData, liftEnds } from './terrain'

export type Edit =
  /** A line of cells from one pointer position to the next. Start and goals are never walled in. */
  | { kind: 'paint'; from: Cell; to: Cell; blocked: boolean }
  /** Cells by their numbers, row by row from the upper left. */
  | { kind: 'cells'; cells: Iterable<number>; blocked: boolean }
  | { kind: 'start'; at: Cell }
  /** Moves a goal; the index after the last one adds a goal there. */
  | { kind: 'goal'; index: number; at: Cell }
  | { kind: 'change-goal'; index: number; change: GoalChange }
  | { kind: 'remove-goal'; index: number }
  | { kind: 'clear' }
  /** What parts of the page that are fetched later make of the map. */
  | { kind: 'make'; make: (scenario: Scenario) => Scenario }

export function applyEditTo(scenario: Scenario, edit: Edit): Scenario {
  switch (edit.kind) {
    case 'paint':
      return paint(scenario, lineNumbers(scenario, edit.from, edit.to), edit.blocked)
    case 'cells':
      return paint(scenario, edit.cells, edit.blocked)
    case 'start':
      return moveStart(scenario, edit.at)
    case 'goal':
      return moveGoal(scenario, edit.index, edit.at)
    case 'change-goal':
      return changeGoal(scenario, edit.index, edit.change)
    case 'remove-goal':
      // By slices, the next goal takes over the level of the first.
      return liftEnds(removeGoal(scenario, edit.index)) ?? scenario
    case 'clear':
      return clear(scenario)
    case 'make':
      return edit.make(scenario)
  }
}

/** Why the ground of a terrain refuses an edit, where the reader must be told. */
export type Refusal = 'erase' | 'end' | 'level'

/** Asked when an edit has changed nothing. */
export function refusalOf(scenario: Scenario, edit: Edit): Refusal | null {
  if (edit.kind === 'paint')
    return !edit.blocked && hasNoData(scenario, edit.to) && isInside(scenario, edit.to)
      ? 'erase'
      : null
  if (edit.kind === 'cells') return edit.blocked ? null : unknownOf(scenario, edit.cells)
  if (edit.kind !== 'start' && edit.kind !== 'goal') return null
  if (!isInside(scenario, edit.at) || takenCells(scenario.spec).some((c) => sameCell(c, edit.at)))
    return null
  return hasNoData(scenario, edit.at) ? 'end' : 'level'
}

function unknownOf({ heights }: Scenario, cells: Iterable<number>): Refusal | null {
  for (const cell of cells) if (heights && !Number.isFinite(heights[cell])) return 'erase'
  return null
}

export function isInside(scenario: Scenario, [x, y]: Cell): boolean {
  return x >= 0 && y >= 0 && x < scenario.spec.width && y < scenario.spec.height
}

export function isBlocked(scenario: Scenario, [x, y]: Cell): boolean {
  return scenario.cells[y * scenario.spec.width + x] === 1
}

export function sameCell(a: Cell, b: Cell): boolean {
  return a[0] === b[0] && a[1] === b[1]
}

/** The cells of a straight line, ends included (Bresenham): a fast drag leaves no holes. */
export function lineCells([x0, y0]: Cell, [x1, y1]: Cell): Cell[] {
  const dx = Math.abs(x1 - x0)
  const dy = -Math.abs(y1 - y0)
  const stepX = x0 < x1 ? 1 : -1
  const stepY = y0 < y1 ? 1 : -1
  const cells: Cell[] = []
  let [x, y, error] = [x0, y0, dx + dy]
  for (;;) {
    cells.push([x, y])
    if (x === x1 && y === y1) return cells
    const twice = 2 * error
    if (twice >= dy) {
      error += dy
      x += stepX
    }
    if (twice <= dx) {
      error += dx
      y += stepY
    }
  }
}

/** The numbers of a line's cells, as far as they lie on the map. */
function lineNumbers(scenario: Scenario, from: Cell, to: Cell): number[] {
  return lineCells(from, to)
    .filter((cell) => isInside(scenario, cell))
    .map(([x, y]) => y * scenario.spec.width + x)
}

/** Start and goals stay free, and where there is no data nothing changes. */
function paint(scenario: Scenario, numbers: Iterable<number>, blocked: boolean): Scenario {
  const { spec, heights, cells: before } = scenario
  const ends = new Set(takenCells(spec).map(([x, y]) => y * spec.width + x))
  const value = blocked ? 1 : 0
  let cells: Uint8Array | null = null
  for (const cell of numbers) {
    if (before[cell] === value || ends.has(cell)) continue
    if (heights && !Number.isFinite(heights[cell])) continue
    cells ??= before.slice()
    cells[cell] = value
  }
  return cells ? { ...scenario, cells } : scenario
}

/** The start stays inside and apart from every goal; on a wall it makes its cell free. */
function moveStart(scenario: Scenario, at: Cell): Scenario {
  const { spec } = scenario
  const taken = takenCells(spec).some((cell) => sameCell(cell, at))
  if (!isInside(scenario, at) || taken || hasNoData(scenario, at)) return scenario
  return settled({ ...scenario, spec: { ...spec, start: at } }, scenario, at)
}

function moveGoal(scenario: Scenario, index: number, at: Cell): Scenario {
  if (hasNoData(scenario, at)) return scenario
  return settled(placeGoal(scenario, index, at), scenario, at)
}

/** `after` with free ground at `at`, and by slices above it; an edit that changed nothing frees nothing. */
function settled(after: Scenario, before: Scenario, at: Cell): Scenario {
  if (after === before) return after
  const lifted = liftEnds(after)
  if (lifted === null) return before
  if (!isBlocked(lifted, at)) return lifted
  const cells = lifted.cells.slice()
  cells[at[1] * lifted.spec.width + at[0]] = 0
  return { ...lifted, cells }
}

/** Where there is no data, nothing can be free. */
function clear(scenario: Scenario): Scenario {
  const { heights } = scenario
  const cells = scenario.cells.map((cell, i) =>
    heights && !Number.isFinite(heights[i]) ? cell : 0,
  )
  if (cells.every((cell, i) => cell === scenario.cells[i])) return scenario
  return { ...scenario, cells, origin: heights ? scenario.origin : null }
}
