/** How far a path is above the proven optimum. */
const EQUAL = 1e-9

/** Relative length above the optimum; null while either is unknown. 0 exactly when they agree. */
export function gapOf(length: number | null | undefined, optimum: number | null): number | null {
  if (length == null || optimum === null || !Number.isFinite(optimum)) return null
  if (optimum === 0) return 0
  const gap = length / optimum - 1
  return Math.abs(gap) < EQUAL ? 0 : gap
}
