/**
 * A comparison as a link: question, maps and what was recorded, without the runs.
 *
 *     u32 checksum · u8 container version · varint n · n bytes of JSON (`formicarium/comparison@1`)
 *     and, where it fits, varint m · m bytes of JSON: what came out (share/recorded_numbers.ts)
 *
 * Whatever stands behind is for later pages: what is not known is not read.
 *
 * Behind the text may stand whose share of the runs is asked for (share_of_class.ts).
 *
 * The same checksum and packing as a session's link (share/codec.ts, share/envelope.ts).
 */
import { Reader, varint } from './byte_stream'
import { MAX_BYTES, verifiedBytes, withChecksum } from './codec'
import { open, seal } from './envelope'
import { damaged, LinkError } from './link_error'
import { textBehind } from './link_in_text'
import { type NumbersOfLink, packedNumbers, readNumbers } from './recorded_numbers'
import { type ShareOfClass, splitShare } from './share_of_class'

export const PREFIX = '#q='

const VERSION = 1

/** What a link tells beside the document. */
export interface ToldByLink {
  /** What came out of its runs; null in links that do not tell. */
  numbers: NumbersOfLink | null
  /** Left out where all runs are asked for. */
  share?: ShareOfClass
}

/** What a link carries. */
export interface ComparisonLink extends ToldByLink {
  /** `formicarium/comparison@1` without its runs. */
  document: string
}

/** The text after `#q=`. */
export async function encodeDocument(
  document: string,
  numbers: NumbersOfLink | null = null,
): Promise<string> {
  const json = new TextEncoder().encode(document)
  if (json.length > MAX_BYTES)
    throw new LinkError('link-too-large', `A link carries no document of ${json.length} bytes.`)
  const parts = [[VERSION, ...varint(json.length)], json]
  if (numbers) {
    const told = new TextEncoder().encode(packedNumbers(numbers))
    parts.push(varint(told.length), told)
  }
  return seal(withChecksum(parts))
}

/** What an address carries. Throws a LinkError. */
export async function decodeFragment(hash: string): Promise<ComparisonLink> {
  const { text, share } = splitShare(textBehind(PREFIX, hash, 'comparison'))
  const reader = new Reader(verifiedBytes(await open(text)))
  const version = reader.byte()
  if (version > VERSION)
    throw new LinkError(
      'link-newer',
      `The link's container has version ${version}; this page reads ${VERSION}.`,
    )
  if (version < VERSION) throw damaged('its first byte is no container version')
  const document = textOf(reader)
  const numbers = reader.left > 0 ? readNumbers(parsed(textOf(reader))) : null
  return { document, numbers, ...(share && { share }) }
}

function textOf(reader: Reader): string {
  const bytes = reader.take(reader.varint())
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes)
  } catch {
    throw damaged('its description cannot be read')
  }
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch {
    throw damaged('its numbers cannot be read')
  }
}
