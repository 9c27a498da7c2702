/**
 * How many characters a link's text has, told in its beginning, so that one that lost its end can say how much is missing.
 *
 * The length stands before the packed bytes as empty stored blocks of deflate, `ddddd000` `00 00 ff ff` each: the five bits before a
 * block's length mean nothing to deflate, so pages that know nothing of this unpack the same. They are the length's digits to the base
 * 32, the highest first; noughts may stand before them.
 */
import { fromBase64url } from './base64url'

const BASE = 32
const EMPTY = [0, 0, 0xff, 0xff]
const BLOCK = 1 + EMPTY.length
const MOST_DIGITS = 6

/** Bytes before the blocks: the one that names the way of packing. */
const BEFORE = 1

/**
 * The blocks for a text of so many other bytes. A number of bytes that three divides could end in `-` or `_`, which programs take for no
 * part of an address: then there is one block more.
 */
export function blocksOfLength(others: number): number[] {
  for (let digits = 1; ; digits++) {
    const bytes = others + BLOCK * digits
    const length = Math.ceil((bytes * 4) / 3)
    if (bytes % 3 === 0 || length >= BASE ** digits) continue
    const digit = (k: number) => Math.floor(length / BASE ** (digits - 1 - k)) % BASE
    return Array.from({ length: digits }, (_, k) => [digit(k) << 3, ...EMPTY]).flat()
  }
}

/** Null where none is told: in links of before, and where hardly anything is left. */
export function toldLength(text: string): number | null {
  const most = Math.ceil((BEFORE + BLOCK * (MOST_DIGITS + 1)) / 3) * 4
  const head = text.slice(0, Math.min(most, text.length - (text.length % 4)))
  if (head === '') return null
  const bytes = fromBase64url(head)
  let length = 0
  for (let at = BEFORE; at + BLOCK <= bytes.length; at += BLOCK) {
    const [first = 0, ...rest] = bytes.subarray(at, at + BLOCK)
    if (first % 8 !== 0 || rest.some((byte, k) => byte !== EMPTY[k]))
      return at === BEFORE ? null : length
    length = length * BASE + first / 8
  }
  return null
}
