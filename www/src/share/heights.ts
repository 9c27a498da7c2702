/**
 * The heights of a terrain as bytes, and back. First a byte that says how:
 *
 *     0  decimals:  u8 places p · varint s · 1 if some have no data, and then a bit a cell that says which · zig-zag varints, each the
 *                   difference from the height before; height = s · number / 10^p
 *     1  floats:    the bits of each height xor those of the one before, all lowest bytes first, then the next ones
 *
 * Surveyed heights are whole numbers, or have a few decimals; only what was computed needs all its bits.
 */
import { bitsOf, joined, type Reader, readBits, varint, varints } from './byte_stream'
import { damaged } from './link_error'

const DECIMALS = 0
const FLOATS = 1
const MOST_PLACES = 3
/** Differences of these, times two, fit a varint. */
const LARGEST = 2 ** 25

export function packHeights(heights: Float32Array): Uint8Array {
  return packDecimals(heights) ?? packFloats(heights)
}

/** Everything that is read is checked against `count` before room is made for it. */
export function unpackHeights(reader: Reader, count: number): Float32Array {
  switch (reader.byte()) {
    case DECIMALS:
      return unpackDecimals(reader, count)
    case FLOATS:
      return unpackFloats(reader, count)
    default:
      throw damaged('its heights are packed in no known way')
  }
}

function packDecimals(heights: Float32Array): Uint8Array | null {
  const places = placesOf(heights)
  if (places === null) return null
  const scale = 10 ** places
  const missing = Uint8Array.from(heights, (height) => (Number.isNaN(height) ? 1 : 0))
  const whole = Int32Array.from(heights.filter(Number.isFinite), (height) =>
    Math.round(height * scale),
  )
  const step = whole.reduce(commonDivisor, 0) || 1
  let before = 0
  const differences = whole.map((value) => {
    const difference = (value - before) / step
    before = value
    return difference < 0 ? -2 * difference - 1 : 2 * difference
  })
  const gaps = missing.includes(1) ? [[1], bitsOf(missing)] : [[0]]
  return joined([[DECIMALS, places, ...varint(step)], ...gaps, varints(differences)])
}

function unpackDecimals(reader: Reader, count: number): Float32Array {
  const places = reader.byte()
  const step = reader.varint()
  if (places > MOST_PLACES) throw damaged('its heights have too many decimals')
  const missing = reader.byte() === 1 ? readBits(reader, count) : null
  // A byte a height at least: nothing is made for heights that cannot be there.
  const known = count - (missing?.reduce((sum, flag) => sum + flag, 0) ?? 0)
  if (reader.left < known) throw damaged('it ends too early')
  const heights = new Float32Array(count)
  let value = 0
  for (let i = 0; i < count; i++) {
    if (missing?.[i] === 1) heights[i] = Number.NaN
    else {
      const code = reader.varint()
      value += step * (code & 1 ? -(code + 1) / 2 : code / 2)
      heights[i] = value / 10 ** places
    }
  }
  return heights
}

/** How many decimals tell every height exactly; null when they are too many, or the numbers too large. */
function placesOf(heights: Float32Array): number | null {
  for (let places = 0; places <= MOST_PLACES; places++) {
    const scale = 10 ** places
    const told = heights.every((height) => {
      if (Number.isNaN(height)) return true
      // Whole numbers know no negative zero.
      if (Object.is(height, -0)) return false
      const whole = Math.round(height * scale)
      return Math.abs(whole) < LARGEST && Math.fround(whole / scale) === height
    })
    if (told) return places
  }
  return null
}

function commonDivisor(a: number, b: number): number {
  let [larger, smaller] = [Math.abs(a), Math.abs(b)]
  while (smaller > 0) [larger, smaller] = [smaller, larger % smaller]
  return larger
}

function packFloats(heights: Float32Array): Uint8Array {
  const view = new DataView(heights.buffer, heights.byteOffset, heights.byteLength)
  const bytes = new Uint8Array(1 + 4 * heights.length)
  bytes[0] = FLOATS
  let before = 0
  for (let i = 0; i < heights.length; i++) {
    const bits = bitsOfHeight(view, i)
    const changed = bits ^ before
    before = bits
    for (let byte = 0; byte < 4; byte++)
      bytes[1 + byte * heights.length + i] = (changed >>> (8 * byte)) & 255
  }
  return bytes
}

/** There are many ways to write that there is no data; one is enough. */
function bitsOfHeight(view: DataView, i: number): number {
  return Number.isNaN(view.getFloat32(4 * i, true)) ? 0x7fc00000 : view.getUint32(4 * i, true)
}

function unpackFloats(reader: Reader, count: number): Float32Array {
  const planes = reader.take(4 * count)
  const heights = new Float32Array(count)
  const view = new DataView(heights.buffer)
  let bits = 0
  for (let i = 0; i < count; i++) {
    for (let byte = 0; byte < 4; byte++) bits ^= (planes[byte * count + i] ?? 0) << (8 * byte)
    view.setUint32(4 * i, bits >>> 0, true)
  }
  return heights
}
