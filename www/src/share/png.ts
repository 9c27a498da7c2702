/**
 * A text inside a PNG picture: an iTXt chunk (PNG, third edition, 11.3.3.4) under a keyword of ours, compressed. Programs that show
 * pictures pass it over; many that save them keep it.
 *
 *     8 bytes signature, then chunks: u32 length · 4 letters · that many bytes · u32 CRC over letters and bytes
 *     iTXt: keyword · 0 · 1 (compressed) · 0 (zlib) · language · 0 · translated keyword · 0 · zlib stream of UTF-8
 */
import { buf as crc32 } from 'crc-32'
import { joined } from './byte_stream'
import { deflate, inflate } from './deflate'
import { damaged, LinkError } from './link_error'

const KEYWORD = 'formicarium'
const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10]
/** Length, letters and CRC of a chunk. */
const FRAME = 12
/** No session or comparison is longer. */
const MOST_TEXT = 64 * 1024 * 1024
/** A picture of 64 MB in parts of 8 KB, as most programs write them, has 8,192 chunks. */
const MOST_CHUNKS = 1 << 16

const ascii = (text: string) => Uint8Array.from(text, (char) => char.charCodeAt(0))
const viewOf = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
const KEY = ascii(`${KEYWORD}\0`)
const TEXT_KIND = viewOf(ascii('iTXt')).getUint32(0)

export function isPng(bytes: Uint8Array): boolean {
  return SIGNATURE.every((byte, i) => bytes[i] === byte)
}

/** The picture with a text in it, in the place of any that was there. */
export async function pngWith(png: Uint8Array, text: string): Promise<Uint8Array<ArrayBuffer>> {
  const packed = await deflate(new TextEncoder().encode(text), 'deflate')
  const added = chunk('iTXt', [ascii(KEYWORD), [0, 1, 0, 0, 0], packed])
  const [head, ...rest] = chunksOf(png)
  if (!head) throw damaged('the picture is empty')
  const others = rest.filter((one) => !isOurs(png, one)).map((one) => whole(png, one))
  return joined([SIGNATURE, whole(png, head), added, ...others])
}

/** The text in a picture. Throws a LinkError where there is none. */
export async function textOfPng(png: Uint8Array): Promise<string> {
  const ours = oursIn(png)
  if (!ours) throw new LinkError('picture-bare', 'The picture holds no session or comparison.')
  const end = ours.at + 8 + ours.length
  if (crc32(png.subarray(ours.at + 4, end)) !== viewOf(png).getInt32(end))
    throw damaged('the text in the picture is not the same as when it was made')
  // Two flags, then language and translated keyword, each up to a zero.
  const data = png.subarray(ours.at + 8 + KEY.length, end)
  const language = data.indexOf(0, 2)
  const start = data.indexOf(0, language + 1) + 1
  if (language < 0 || start === 0) throw damaged('the text in the picture ends too early')
  const text = data.slice(start)
  if (data[0] === 0) return decoded(text)
  if (data[1] !== 0) throw damaged('the text in the picture is packed in no known way')
  return decoded(await unpacked(text))
}

interface Chunk {
  /** Where it begins. */
  at: number
  /** Four letters as a number. */
  kind: number
  /** Bytes between its letters and its CRC. */
  length: number
}

/** The first chunk of ours; what comes after it is not looked at. */
function oursIn(png: Uint8Array): Chunk | null {
  for (const one of chunksOf(png)) if (isOurs(png, one)) return one
  return null
}

const isOurs = (png: Uint8Array, { at, kind, length }: Chunk) =>
  kind === TEXT_KIND && length >= KEY.length && KEY.every((byte, i) => png[at + 8 + i] === byte)

const whole = (png: Uint8Array, { at, length }: Chunk) => png.subarray(at, at + FRAME + length)

/** What stands after the last whole chunk is left out: such a picture can still be seen. */
function* chunksOf(png: Uint8Array): Generator<Chunk> {
  const view = viewOf(png)
  let count = 0
  for (let at = SIGNATURE.length; at + FRAME <= png.length; ) {
    const length = view.getUint32(at)
    if (at + FRAME + length > png.length) return
    if (++count > MOST_CHUNKS) throw damaged(`the picture has more than ${MOST_CHUNKS} parts`)
    yield { at, kind: view.getUint32(at + 4), length }
    at += FRAME + length
  }
}

function chunk(kind: string, parts: ArrayLike<number>[]): Uint8Array {
  const covered = joined([ascii(kind), ...parts])
  const frame = new DataView(new ArrayBuffer(8))
  frame.setUint32(0, covered.length - 4)
  frame.setInt32(4, crc32(covered))
  const bytes = new Uint8Array(frame.buffer)
  return joined([bytes.subarray(0, 4), covered, bytes.subarray(4)])
}

function unpacked(zlib: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  return inflate(zlib, MOST_TEXT, 'deflate').catch((error: unknown) => {
    throw error instanceof LinkError ? error : damaged('the text in the picture cannot be unpacked')
  })
}

function decoded(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes)
  } catch {
    throw damaged('what the picture holds is no text')
  }
}
