/**
 * Container bytes ⇄ fragment text: base64url of one byte (0 stored, 1 deflated) and the bytes. What is written is deflated, tells its own
 * length (told_length.ts), and ends in a letter or a digit.
 */
import { fromBase64url, toBase64url } from './base64url'
import { joined } from './byte_stream'
import { MAX_BYTES } from './codec'
import { deflate, inflate } from './deflate'
import { changed, cutShort, damaged, LinkError } from './link_error'
import { blocksOfLength, toldLength } from './told_length'

/** Longer links are cut by some hosts and mail programs: offer a file instead. Characters of the fragment's payload. */
export const LINK_LIMIT = 8000

const SHORTEST_LINE = 20

const STORED = 0
const DEFLATED = 1

export async function seal(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const packed = await deflate(bytes)
  return toBase64url(joined([[DEFLATED], blocksOfLength(1 + packed.length), packed]))
}

/** `text` may be in several words: a program has broken it, or the words behind are none of it. Throws a LinkError. */
export async function open(text: string): Promise<Uint8Array> {
  if (text.length > 2 * MAX_BYTES)
    throw new LinkError('link-too-large', 'The link is longer than any map needs.')
  const words = text.split(' ')
  const told = toldLength(words.join(''))
  let fault: unknown
  for (const candidate of candidates(words, told)) {
    try {
      return await unsealed(candidate)
    } catch (error) {
      // Of what is too large the rest would be, too.
      if (isTooLarge(error)) throw error
      fault ??= error
    }
  }
  throw told === null ? fault : missing(words, told)
}

/** What the text may be, the likeliest first. Only one that is whole can be unpacked. */
function candidates(words: string[], told: number | null): Set<string> {
  const heads = words.map((_, at) => words.slice(0, at + 1).join(''))
  const whole = heads.at(-1) ?? ''
  return new Set(told === null ? heads : [whole.slice(0, told), whole])
}

async function unsealed(text: string): Promise<Uint8Array> {
  const sealed = fromBase64url(text)
  const payload = sealed.subarray(1)
  switch (sealed[0]) {
    case STORED:
      return payload
    case DEFLATED:
      return inflate(payload, MAX_BYTES).catch((error: unknown) => {
        throw error instanceof LinkError ? error : damaged('it cannot be unpacked')
      })
    default:
      throw damaged('its first byte names no way of packing')
  }
}

const isTooLarge = (error: unknown) => error instanceof LinkError && error.kind === 'link-too-large'

/** What is wrong with a link that knows its length. Where programs break links, lines are long: words behind it are none of it. */
function missing(words: string[], told: number): LinkError {
  const end = words.findIndex((word, at) => at > 0 && word.length < SHORTEST_LINE)
  const lengthOf = (some: string[]) => some.join('').length
  const here = lengthOf(end < 0 ? words : words.slice(0, end))
  return here < told && lengthOf(words) !== told ? cutShort(told - here, told) : changed()
}
