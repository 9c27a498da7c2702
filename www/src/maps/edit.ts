/** Edits of a scenario, as pure functions: the same object comes back when an edit changes nothing. */
import type { Scenario } from '../session'
import { changeGoal, type GoalChange, isGoal, placeGoal, removeGoal, takenCells } from './goals'
import { keepInside } from './settle'

export type Cell = [number, number]

export type Edit =
  /** A line of cells from one pointer position to the next. Start and goals are never walled in. */
  | { kind: 'paint'; from: Cell; to: Cell; blocked: boolean }
  | { kind: 'start'; at: Cell }
  /** Moves a goal; the index after the last one adds a goal there. */
  | { kind: 'goal'; index: number; at: Cell }
  | { kind: 'change-goal'; index: number; change: GoalChange }
  | { kind: 'remove-goal'; index: number }
  | { kind: 'clear' }
  | { kind: 'resize'; width: number; height: number }

export function applyEditTo(scenario: Scenario, edit: Edit): Scenario {
  switch (edit.kind) {
    case 'paint':
      return paint(scenario, edit.from, edit.to, edit.blocked)
    case 'start':
      return moveStart(scenario, edit.at)
    case 'goal':
      return freed(placeGoal(scenario, edit.index, edit.at), scenario, edit.at)
    case 'change-goal':
      return changeGoal(scenario, edit.index, edit.change)
    case 'remove-goal':
      return removeGoal(scenario, edit.index)
    case 'clear':
      return clear(scenario)
    case 'resize':
      return resize(scenario, edit.width, edit.height)
  }
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

function paint(scenario: Scenario, from: Cell, to: Cell, blocked: boolean): Scenario {
  const value = blocked ? 1 : 0
  const changing = lineCells(from, to).filter(
    (cell) =>
      isInside(scenario, cell) &&
      isBlocked(scenario, cell) !== blocked &&
      !sameCell(cell, scenario.spec.start) &&
      !isGoal(scenario, cell),
  )
  if (changing.length === 0) return scenario
  const cells = scenario.cells.slice()
  for (const [x, y] of changing) cells[y * scenario.spec.width + x] = value
  return { ...scenario, cells }
}

/** The start stays inside and apart from every goal; on a wall it makes its cell free. */
function moveStart(scenario: Scenario, at: Cell): Scenario {
  const { spec } = scenario
  if (!isInside(scenario, at) || takenCells(spec).some((cell) => sameCell(cell, at)))
    return scenario
  return freed({ ...scenario, spec: { ...spec, start: at } }, scenario, at)
}

/** `after` with free ground at `at`; an edit that changed nothing frees nothing. */
function freed(after: Scenario, before: Scenario, at: Cell): Scenario {
  if (after === before || !isBlocked(after, at)) return after
  const cells = after.cells.slice()
  cells[at[1] * after.spec.width + at[0]] = 0
  return { ...after, cells }
}

function clear(scenario: Scenario): Scenario {
  if (!scenario.cells.includes(1)) return scenario
  return { ...scenario, cells: new Uint8Array(scenario.cells.length), origin: null }
}

/** Keeps the upper left part; new cells are free, ends that fell off move to the nearest cell inside. */
function resize(scenario: Scenario, width: number, height: number): Scenario {
  const { spec } = scenario
  if (width === spec.width && height === spec.height) return scenario
  const cells = new Uint8Array(width * height)
  for (let y = 0; y < Math.min(height, spec.height); y++) {
    const row = scenario.cells.subarray(
      y * spec.width,
      y * spec.width + Math.min(width, spec.width),
    )
    cells.set(row, y * width)
  }
  const moved = keepInside({ ...spec, width, height })
  for (const [x, y] of takenCells(moved)) cells[y * width + x] = 0
  return { spec: moved, cells, origin: null }
}
