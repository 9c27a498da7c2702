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

const ascii = (text: string) => Uint8Array.from(text, (char) => char.charCodeAt(0))

export function isPng(bytes: Uint8Array): boolean {
  return SIGNATURE.every((byte, i) => bytes[i] === byte)
}

/** The picture with a text in it, in the place of any that was there. */
export async function pngWith(png: Uint8Array, text: string): Promise<Uint8Array<ArrayBuffer>> {
  const packed = await deflate(new TextEncoder().encode(text), 'deflate')
  const added = chunk('iTXt', [ascii(KEYWORD), [0, 1, 0, 0, 0], packed])
  const [head, ...rest] = chunksOf(png)
  if (!head) throw damaged('the picture is empty')
  const others = rest.filter((one) => !isOurs(one))
  return joined([SIGNATURE, head.whole, added, ...others.map(({ whole }) => whole)])
}

/** The text in a picture. Throws a LinkError where there is none. */
export async function textOfPng(png: Uint8Array): Promise<string> {
  const ours = chunksOf(png).find(isOurs)
  if (!ours) throw new LinkError('picture-bare', 'The picture holds no session or comparison.')
  if (crc32(ours.whole.subarray(4, -4)) !== intAt(ours.whole, ours.whole.length - 4))
    throw damaged('the text in the picture is not the same as when it was made')
  // Two flags, then language and translated keyword, each up to a zero.
  const data = ours.data.subarray(KEYWORD.length + 1)
  const language = data.indexOf(0, 2)
  const start = data.indexOf(0, language + 1) + 1
  if (language < 0 || start === 0) throw damaged('the text in the picture ends too early')
  const text = data.slice(start)
  if (data[0] === 0) return decoded(text)
  if (data[1] !== 0) throw damaged('the text in the picture is packed in no known way')
  return decoded(await unpacked(text))
}

interface Chunk {
  kind: string
  data: Uint8Array
  whole: Uint8Array
}

const isOurs = ({ kind, data }: Chunk) =>
  kind === 'iTXt' && ascii(`${KEYWORD}\0`).every((byte, i) => data[i] === byte)

/** What stands after the last whole chunk is left out: such a picture can still be seen. */
function chunksOf(png: Uint8Array): Chunk[] {
  const chunks: Chunk[] = []
  for (let at = SIGNATURE.length; at + FRAME <= png.length; ) {
    const length = intAt(png, at) >>> 0
    if (at + FRAME + length > png.length) break
    const whole = png.subarray(at, at + FRAME + length)
    const kind = String.fromCharCode(...whole.subarray(4, 8))
    chunks.push({ kind, data: whole.subarray(8, 8 + length), whole })
    at += whole.length
  }
  return chunks
}

function chunk(kind: string, parts: ArrayLike<number>[]): Uint8Array {
  const covered = joined([ascii(kind), ...parts])
  const frame = new DataView(new ArrayBuffer(8))
  frame.setUint32(0, covered.length - 4)
  frame.setInt32(4, crc32(covered))
  const bytes = new Uint8Array(frame.buffer)
  return joined([bytes.subarray(0, 4), covered, bytes.subarray(4)])
}

const intAt = (bytes: Uint8Array, at: number) =>
  new DataView(bytes.buffer, bytes.byteOffset).getInt32(at)

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
