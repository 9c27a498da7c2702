/** At which iterations steps are taken. Pure functions. */

/** From the beginning to the last iteration, at most so many. */
export function evenly(last: number, steps: number): number[] {
  const all = Array.from({ length: steps }, (_, i) => Math.round((i * last) / (steps - 1)))
  return [...new Set(all)]
}

/** The beginning, the last iteration, and as many of the others as there is room for. */
export function thinned(improved: number[], last: number, steps: number): number[] {
  const all = [...new Set([0, ...improved, last])].sort((a, b) => a - b)
  if (all.length <= steps) return all
  return evenly(all.length - 1, steps).map((index) => all[index] ?? last)
}
