/** How far a result is from its reference, as a number and as text. */

/** The part of a value by which two ways to sum up the same path may differ, as the engine has it (src/comparison/gap.rs). */
const ROUNDING = 1e-9
/** The last digit of a gap that is shown; what is half of it or more is rounded up to it. */
const LAST_DIGIT = 0.001

/** value / best − 1; 0 within a rounding, and where the best is 0. */
export function relativeGap(value: number, best: number): number {
  const gap = best > 0 ? value / best - 1 : 0
  return Math.abs(gap) < ROUNDING ? 0 : gap
}

/** Only what is the reference is shown as nothing: a gap that would be rounded to it is said to be smaller than the last digit. */
export function gapText(gap: number, percent: Intl.NumberFormat): string {
  if (gap === 0 || Math.abs(gap) >= LAST_DIGIT / 2) return percent.format(gap)
  // The sign of an excess says nothing beside "<".
  return gap > 0
    ? `< ${percent.format(LAST_DIGIT).replace('+', '')}`
    : `> ${percent.format(-LAST_DIGIT)}`
}
