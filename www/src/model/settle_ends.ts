/** Finds places for start and goals when a map gets smaller. */
import type { Goal, ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from './cell'

/**
 * After a change of size: what fell off, or stands where nothing fits, moves to the nearest cell inside that nothing else has. Null when
 * there is no place for the start, or for any goal.
 */
export function keepInside(
  spec: ScenarioSpec,
  fits: (cell: number) => boolean = () => true,
): ScenarioSpec | null {
  const { width, height } = spec
  const start = nearest(inside(spec.start, width, height), width, height, fits)
  if (start === null) return null
  const taken = new Set([key(start, width)])
  // Those that need not move have the first claim to their cells.
  const fixed = spec.goals.filter(
    ({ at: [x, y] }) => x < width && y < height && fits(y * width + x),
  )
  for (const { at } of fixed) taken.add(key(at, width))
  const settled: Goal[] = []
  for (const goal of spec.goals) {
    const keeps = fixed.includes(goal) && key(goal.at, width) !== key(start, width)
    const free = (cell: number) => fits(cell) && !taken.has(cell)
    const at = keeps ? goal.at : nearest(inside(goal.at, width, height), width, height, free)
    // More goals than cells: the rest has to go.
    if (at === null) continue
    taken.add(key(at, width))
    settled.push({ ...goal, at })
  }
  return settled.length === 0 && spec.goals.length > 0 ? null : { ...spec, start, goals: settled }
}

/** The number of a cell, row by row. */
export const key = ([x, y]: Cell, width: number) => y * width + x

function inside([x, y]: Cell, width: number, height: number): Cell {
  return [Math.min(x, width - 1), Math.min(y, height - 1)]
}

/** The first cell that fits, in growing squares about a cell; null when none does. */
export function nearest(
  [x, y]: Cell,
  width: number,
  height: number,
  fits: (cell: number) => boolean,
): Cell | null {
  for (let radius = 0; radius < Math.max(width, height); radius++) {
    let best: { at: Cell; away: number } | null = null
    for (const at of ring([x, y], radius)) {
      if (at[0] < 0 || at[1] < 0 || at[0] >= width || at[1] >= height) continue
      const away = Math.hypot(at[0] - x, at[1] - y)
      if (fits(key(at, width)) && (best === null || away < best.away)) best = { at, away }
    }
    if (best !== null) return best.at
  }
  return null
}

function* ring([x, y]: Cell, radius: number): Generator<Cell> {
  if (radius === 0) yield [x, y]
  for (let i = -radius; i < radius; i++) {
    yield [x + i, y - radius]
    yield [x + radius, y + i]
    yield [x - i, y + radius]
    yield [x - radius, y - i]
  }
}
