/** Edits of a scenario, as pure functions: the same object comes back when an edit changes nothing. */
import { goalAt, type Scenario } from '../session'

export type Cell = [number, number]

export type Edit =
  /** A line of cells from one pointer position to the next. Start and goal are never walled in. */
  | { kind: 'paint'; from: Cell; to: Cell; blocked: boolean }
  | { kind: 'start'; at: Cell }
  | { kind: 'goal'; at: Cell }
  | { kind: 'clear' }
  | { kind: 'resize'; width: number; height: number }

export function applyEditTo(scenario: Scenario, edit: Edit): Scenario {
  switch (edit.kind) {
    case 'paint':
      return paint(scenario, edit.from, edit.to, edit.blocked)
    case 'start':
      return moveEnd(scenario, 'start', edit.at)
    case 'goal':
      return moveEnd(scenario, 'goal', edit.at)
    case 'clear':
      return clear(scenario)
    case 'resize':
      return resize(scenario, edit.width, edit.height)
  }
}

/** The goal of a scenario with one goal. */
export function goalOf(scenario: Scenario): Cell {
  return scenario.spec.goals[0]?.at ?? scenario.spec.start
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
  const goal = goalOf(scenario)
  const changing = lineCells(from, to).filter(
    (cell) =>
      isInside(scenario, cell) &&
      isBlocked(scenario, cell) !== blocked &&
      !sameCell(cell, scenario.spec.start) &&
      !sameCell(cell, goal),
  )
  if (changing.length === 0) return scenario
  const cells = scenario.cells.slice()
  for (const [x, y] of changing) cells[y * scenario.spec.width + x] = value
  return { ...scenario, cells }
}

/** Start and goal stay inside and apart; on a wall they make their cell free. */
function moveEnd(scenario: Scenario, end: 'start' | 'goal', at: Cell): Scenario {
  const { spec } = scenario
  const other = end === 'start' ? goalOf(scenario) : spec.start
  const here = end === 'start' ? spec.start : goalOf(scenario)
  if (!isInside(scenario, at) || sameCell(at, other) || sameCell(at, here)) return scenario
  const goal = spec.goals[0] ?? goalAt(at, '')
  const moved = end === 'start' ? { ...spec, start: at } : { ...spec, goals: [{ ...goal, at }] }
  return { ...scenario, spec: moved, cells: freed(scenario, at) }
}

function freed(scenario: Scenario, at: Cell): Uint8Array {
  if (!isBlocked(scenario, at)) return scenario.cells
  const cells = scenario.cells.slice()
  cells[at[1] * scenario.spec.width + at[0]] = 0
  return cells
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
  const start = inside(spec.start, width, height)
  const goal = apart(inside(goalOf(scenario), width, height), start, width, height)
  for (const [x, y] of [start, goal]) cells[y * width + x] = 0
  const kept = spec.goals[0] ?? goalAt(goal, '')
  return {
    spec: { ...spec, width, height, start, goals: [{ ...kept, at: goal }] },
    cells,
    origin: null,
  }
}

function inside([x, y]: Cell, width: number, height: number): Cell {
  return [Math.min(x, width - 1), Math.min(y, height - 1)]
}

/** Shrinking can push both ends into one corner: then the goal steps aside. */
function apart(goal: Cell, start: Cell, width: number, height: number): Cell {
  if (!sameCell(goal, start)) return goal
  if (width > 1) return [goal[0] > 0 ? goal[0] - 1 : 1, goal[1]]
  return [goal[0], goal[1] > 0 ? goal[1] - 1 : Math.min(1, height - 1)]
}
