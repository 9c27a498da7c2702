/** Which part of curves over effort is shown. */
import type { BandPoint } from '../../model/analysis'

/** Where curves begin and end. */
export interface Ends {
  first: number
  last: number
}

/** An effort of 0 (a search has no iterations) has no place on a logarithmic scale: there it is drawn at the least above 0. */
export function endsOf(efforts: number[], logarithmic: boolean): Ends {
  const above = efforts.filter((x) => x > 0)
  const first = above.length > 0 ? Math.min(...above) : 1
  const last = Math.max(first, ...above)
  return { first: logarithmic ? first : 0, last: last > first ? last : 10 * first }
}

/** Within the ends; of what happened before the first place in sight, the last counts. */
export function placed<P extends { x: number }>(points: P[], { first }: Ends): P[] {
  const next = (i: number) => points[i + 1]?.x ?? Number.POSITIVE_INFINITY
  const begun = points.filter(({ x }, i) => x > first || next(i) > first)
  return begun.map((point) => ({ ...point, x: Math.max(first, point.x) }))
}

export interface Limits {
  low: number
  high: number
  /** The largest value there is. */
  most: number
}

/**
 * First paths may be many times as long as last ones, which is where entries differ: what lies far above every last value is cut off,
 * and the figure says so.
 */
export function limitsOf(bands: BandPoint[][], optima: number[]): Limits {
  const all = bands.flat().flatMap(numbersOf)
  const lasts = bands.flatMap((band) => band.slice(-1).flatMap(numbersOf))
  const least = Math.min(...all, ...optima)
  const [worst, most] = [Math.max(...lasts, least), Math.max(...all)]
  const room = Math.max(2.5 * (worst - least), 0.06 * Math.abs(least), 1e-9)
  const high = worst + room < most / 1.1 ? worst + room : most
  return { low: least - 0.04 * (high - least), high, most }
}

const numbersOf = ({ lower, median, upper }: BandPoint) =>
  [lower, median, upper].filter((value) => value !== null)
