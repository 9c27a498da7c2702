/** Lengths of scale bars: 1, 2 or 5 times a power of ten. */

/** The longest one of at most `most` pixels. `perPixel`: how much a pixel is, above 0. */
export function roundLength(perPixel: number, most: number): number {
  const limit = perPixel * most
  const power = 10 ** Math.floor(Math.log10(limit))
  const times = [5, 2].find((n) => n * power <= limit) ?? 1
  // 2 · 0.1 and the like, without what is left of rounding.
  return Number((times * power).toPrecision(1))
}
