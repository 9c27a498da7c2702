/** How metres are rounded. */

/** Decimals of metres: down to centimetres at least, to micrometres at most. */
const [FEWEST, MOST] = [2, 6]

/** How many decimals tell lengths apart on a map of so many metres a cell. */
export const decimalsFor = (resolution: number): number =>
  Math.min(MOST, Math.max(FEWEST, Math.ceil(-Math.log10(resolution))))

/** Of a scale bar: the longest length that is 1, 2 or 5 times a power of ten, of at most `most` pixels. `perPixel`: how much a pixel is, above 0. */
export function roundLength(perPixel: number, most: number): number {
  const limit = perPixel * most
  const power = 10 ** Math.floor(Math.log10(limit))
  const times = [5, 2].find((n) => n * power <= limit) ?? 1
  // 2 · 0.1 and the like, without what is left of rounding.
  return Number((times * power).toPrecision(1))
}
