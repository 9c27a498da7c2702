/** How far whiskers reach, and how the points of a distribution are spread. */
import type { Summary } from '../../model/analysis'

/** Tukey's rule. */
const WHISKER = 1.5
/** To the furthest values within one and a half interquartile ranges of the box. */
export function whiskers(
  all: (number | null)[],
  { lower, upper }: Summary,
): { low: number; high: number } {
  const reach = WHISKER * (upper - lower)
  const within = all
    .filter((v) => v !== null)
    .filter((v) => v >= lower - reach && v <= upper + reach)
  return { low: Math.min(lower, ...within), high: Math.max(upper, ...within) }
}

/** −1 to 1, from the seed alone (Weyl's sequence of the golden ratio), so that a run has the same height in every picture. */
export function jitter(seed: number): number {
  return 2 * ((seed * 0.618_033_988_749_895) % 1) - 1
}
