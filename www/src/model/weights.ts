/** Ground that costs more than its length: factors of cells, as pure functions. */
import type { Cell } from './cell'
import type { MapCells, Scenario } from './session'

/** Of plain ground, which costs its length. */
export const PLAIN = 1
/** The largest factor that the engine takes: beyond it a wall is meant. */
export const MOST_FACTOR = 1000

/** From here on all ground has the same tint, as the engine paints it. */
export const DEAREST = 10

/** The same factors; null where all ground is plain. */
export function plainOrNone(factors: Float32Array): Float32Array | null {
  return factors.every((factor) => factor === PLAIN) ? null : factors
}

/** How strong the tint of a factor is, from 0 to 1: by its logarithm. */
export const strengthOf = (factor: number): number =>
  Math.min(1, Math.log(factor) / Math.log(DEAREST))

/** By how much a way through the cell counts more than its length. */
export function factorAt({ factors, spec }: Scenario, [x, y]: Cell): number {
  return factors?.[y * spec.width + x] ?? PLAIN
}

/** The largest factor of a free cell. */
export function mostFactor({ cells, factors }: Pick<MapCells, 'cells' | 'factors'>): number {
  return (
    factors?.reduce((most, factor, i) => (cells[i] === 0 ? Math.max(most, factor) : most), PLAIN) ??
    PLAIN
  )
}

/** Gives cells, by their numbers, another factor; walls among them stay as they are. Nothing changes on a terrain. */
export function weighed(scenario: Scenario, numbers: Iterable<number>, factor: number): Scenario {
  const { cells, heights, factors: before } = scenario
  const value = Math.fround(factor)
  if (heights) return scenario
  let factors: Float32Array | null = null
  for (const cell of numbers) {
    if (cells[cell] !== 0 || ((factors ?? before)?.[cell] ?? PLAIN) === value) continue
    factors ??= before?.slice() ?? new Float32Array(cells.length).fill(PLAIN)
    factors[cell] = value
  }
  return factors ? { ...scenario, cells: cells.slice(), factors: plainOrNone(factors) } : scenario
}
