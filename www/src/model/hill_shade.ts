/** A small picture of a terrain, lit from the north-west: to recognise it, not to measure it. */

/** From the lowest ground to the highest, as red, green, blue. */
const TINTS = [
  [126, 160, 136],
  [190, 196, 158],
  [222, 206, 170],
  [244, 240, 232],
] as const
/** Slopes are drawn this steep on average, so that flat country shows its relief, too. */
const DRAWN_SLOPE = 0.5
/** Light from the north-west, 45° high. */
const LIGHT = [-0.5, -0.5, Math.SQRT1_2] as const

/** One pixel a height, row by row; without data transparent. `cell`: metres a pixel across and down. */
export function hillShade(
  heights: Float32Array,
  width: number,
  cell: readonly [number, number],
): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * heights.length)
  const slope = slopes(heights, width, cell)
  const exaggeration = DRAWN_SLOPE / (meanOf(slope.map(([x, y]) => Math.hypot(x, y))) || 1)
  const [lowest, highest] = rangeOf(heights)
  for (let i = 0; i < heights.length; i++) {
    const height = heights[i] ?? Number.NaN
    if (!Number.isFinite(height)) continue
    const [x, y] = slope[i] ?? [0, 0]
    const light = lit(x * exaggeration, y * exaggeration)
    const tint = tintOf((height - lowest) / (highest - lowest || 1))
    for (let c = 0; c < 3; c++) pixels[4 * i + c] = (tint[c] ?? 0) * light
    pixels[4 * i + 3] = 255
  }
  return pixels
}

/** Rise per metre eastwards and southwards; flat where a neighbour is unknown. */
function slopes(
  heights: Float32Array,
  width: number,
  [dx, dy]: readonly [number, number],
): [number, number][] {
  const rise = (a: number | undefined, b: number | undefined, run: number) => {
    const value = ((b ?? Number.NaN) - (a ?? Number.NaN)) / run
    return Number.isFinite(value) ? value : 0
  }
  return Array.from(heights, (_, i) => {
    const x = i % width
    const [left, right] = [x > 0 ? i - 1 : i, x < width - 1 ? i + 1 : i]
    const [up, down] = [i >= width ? i - width : i, i + width < heights.length ? i + width : i]
    return [
      rise(heights[left], heights[right], dx * (right - left || 1)),
      rise(heights[up], heights[down], (dy * (down - up || width)) / width),
    ]
  })
}

/** Lambert's law on the slope's normal, never quite dark. */
function lit(x: number, y: number): number {
  const facing = (-x * LIGHT[0] - y * LIGHT[1] + LIGHT[2]) / Math.hypot(x, y, 1)
  return 0.35 + 0.75 * Math.max(0, facing)
}

function tintOf(share: number): number[] {
  const place = Math.min(1, Math.max(0, share)) * (TINTS.length - 1)
  const from = Math.min(TINTS.length - 2, Math.floor(place))
  const [low, high] = [TINTS[from] ?? TINTS[0], TINTS[from + 1] ?? TINTS[0]]
  return low.map((value, c) => value + (place - from) * ((high[c] ?? value) - value))
}

function rangeOf(heights: Float32Array): [number, number] {
  let [lowest, highest] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]
  for (const height of heights) {
    if (height < lowest) lowest = height
    if (height > highest) highest = height
  }
  return [lowest, highest]
}

function meanOf(values: number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length
}
