/**
 * Numbers of a map's cells as bytes, and back: the heights of a terrain, or the factors of weighted ground. First a byte that says how:
 *
 *     0  decimals:  u8 places p · varint s · 1 if some have no data, and then a bit a cell that says which · zig-zag varints, each the
 *                   difference from the number before; the cell's is s · number / 10^p
 *     1  floats:    the bits of each xor those of the one before, all lowest bytes first, then the next ones
 *
 * Surveyed heights and chosen factors are whole numbers, or have a few decimals; only what was computed needs all its bits.
 */
import { bitsOf, joined, type Reader, readBits, varint, varints } from './byte_stream'
import { damaged } from './link_error'

const DECIMALS = 0
const FLOATS = 1
const MOST_PLACES = 3
/** Differences of these, times two, fit a varint. */
const LARGEST = 2 ** 25

export function packNumbers(numbers: Float32Array): Uint8Array {
  return packDecimals(numbers) ?? packFloats(numbers)
}

/** Everything that is read is checked against `count` before room is made for it. */
export function unpackNumbers(reader: Reader, count: number): Float32Array {
  switch (reader.byte()) {
    case DECIMALS:
      return unpackDecimals(reader, count)
    case FLOATS:
      return unpackFloats(reader, count)
    default:
      throw damaged('its numbers are packed in no known way')
  }
}

function packDecimals(numbers: Float32Array): Uint8Array | null {
  const places = placesOf(numbers)
  if (places === null) return null
  const scale = 10 ** places
  const missing = Uint8Array.from(numbers, (number) => (Number.isNaN(number) ? 1 : 0))
  const whole = Int32Array.from(numbers.filter(Number.isFinite), (number) =>
    Math.round(number * scale),
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
  if (places > MOST_PLACES) throw damaged('its numbers have too many decimals')
  const missing = reader.byte() === 1 ? readBits(reader, count) : null
  // A byte a number at least: nothing is made for numbers that cannot be there.
  const known = count - (missing?.reduce((sum, flag) => sum + flag, 0) ?? 0)
  if (reader.left < known) throw damaged('it ends too early')
  const numbers = new Float32Array(count)
  let value = 0
  for (let i = 0; i < count; i++) {
    if (missing?.[i] === 1) numbers[i] = Number.NaN
    else {
      const code = reader.varint()
      value += step * (code & 1 ? -(code + 1) / 2 : code / 2)
      numbers[i] = value / 10 ** places
    }
  }
  return numbers
}

/** How many decimals tell every number exactly; null when they are too many, or the numbers too large. */
function placesOf(numbers: Float32Array): number | null {
  for (let places = 0; places <= MOST_PLACES; places++) {
    const scale = 10 ** places
    const told = numbers.every((number) => {
      if (Number.isNaN(number)) return true
      // Whole numbers know no negative zero.
      if (Object.is(number, -0)) return false
      const whole = Math.round(number * scale)
      return Math.abs(whole) < LARGEST && Math.fround(whole / scale) === number
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

function packFloats(numbers: Float32Array): Uint8Array {
  const view = new DataView(numbers.buffer, numbers.byteOffset, numbers.byteLength)
  const bytes = new Uint8Array(1 + 4 * numbers.length)
  bytes[0] = FLOATS
  let before = 0
  for (let i = 0; i < numbers.length; i++) {
    const bits = bitsOfNumber(view, i)
    const changed = bits ^ before
    before = bits
    for (let byte = 0; byte < 4; byte++)
      bytes[1 + byte * numbers.length + i] = (changed >>> (8 * byte)) & 255
  }
  return bytes
}

/** There are many ways to write that there is no data; one is enough. */
function bitsOfNumber(view: DataView, i: number): number {
  return Number.isNaN(view.getFloat32(4 * i, true)) ? 0x7fc00000 : view.getUint32(4 * i, true)
}

function unpackFloats(reader: Reader, count: number): Float32Array {
  const planes = reader.take(4 * count)
  const numbers = new Float32Array(count)
  const view = new DataView(numbers.buffer)
  let bits = 0
  for (let i = 0; i < count; i++) {
    for (let byte = 0; byte < 4; byte++) bits ^= (planes[byte * count + i] ?? 0) << (8 * byte)
    view.setUint32(4 * i, bits >>> 0, true)
  }
  return numbers
}
