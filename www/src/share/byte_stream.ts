/** Bytes of a link, read and written one after the other. */
import { damaged } from './link_error'

/** Numbers of up to this many bits go into a varint. */
const VARINT_BITS = 28

export class Reader {
  private at = 0

  constructor(private readonly bytes: Uint8Array) {}

  /** Bytes that have not been read. */
  get left(): number {
    return this.bytes.length - this.at
  }

  byte(): number {
    const byte = this.bytes[this.at++]
    if (byte === undefined) throw damaged('it ends too early')
    return byte
  }

  varint(): number {
    let value = 0
    for (let shift = 0; shift < VARINT_BITS; shift += 7) {
      const byte = this.byte()
      value |= (byte & 127) << shift
      if (byte < 128) return value
    }
    throw damaged('a number in it is too long')
  }

  take(count: number): Uint8Array {
    if (this.at + count > this.bytes.length) throw damaged('it ends too early')
    this.at += count
    return this.bytes.subarray(this.at - count, this.at)
  }
}

/** Seven bits a byte, lowest first; the high bit says that more follow. */
export function varint(value: number): number[] {
  return value < 128 ? [value] : [(value & 127) | 128, ...varint(value >>> 7)]
}

/** Varints of many numbers: a list of bytes of their own for each would fill the memory. */
export function varints(values: Int32Array): Uint8Array {
  const bytes = new Uint8Array(values.length * 4)
  let at = 0
  for (const value of values) {
    let rest = value
    for (; rest >= 128; rest >>>= 7) bytes[at++] = (rest & 127) | 128
    bytes[at++] = rest
  }
  return bytes.subarray(0, at)
}

export function joined(parts: ArrayLike<number>[]): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0))
  let at = 0
  for (const part of parts) {
    bytes.set(part, at)
    at += part.length
  }
  return bytes
}

/** One bit a flag, most significant first. */
export function bitsOf(flags: Uint8Array): Uint8Array {
  const bits = new Uint8Array(Math.ceil(flags.length / 8))
  for (let i = 0; i < flags.length; i++) {
    if (flags[i] === 1) bits[i >> 3] = (bits[i >> 3] ?? 0) | (128 >> (i & 7))
  }
  return bits
}

export function readBits(reader: Reader, count: number): Uint8Array {
  const bits = reader.take(Math.ceil(count / 8))
  return Uint8Array.from({ length: count }, (_, i) => ((bits[i >> 3] ?? 0) >> (7 - (i & 7))) & 1)
}
