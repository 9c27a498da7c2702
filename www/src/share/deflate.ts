/** Compression by the browser's own streams, with a limit on what a hostile payload may unpack to. */
import { LinkError } from './link_error'

/** With a zlib header, as PNG asks for it, `deflate`. */
type Wrapping = 'deflate-raw' | 'deflate'

export async function deflate(
  bytes: Uint8Array<ArrayBuffer>,
  wrapping: Wrapping = 'deflate-raw',
): Promise<Uint8Array> {
  return collect(through(bytes, new CompressionStream(wrapping)), Number.POSITIVE_INFINITY)
}

/** Stops reading as soon as more than `most` bytes have come out. Throws whatever the stream throws on broken data. */
export async function inflate(
  bytes: Uint8Array<ArrayBuffer>,
  most: number,
  wrapping: Wrapping = 'deflate-raw',
): Promise<Uint8Array> {
  return collect(through(bytes, new DecompressionStream(wrapping)), most)
}

function through(
  bytes: Uint8Array<ArrayBuffer>,
  transform: CompressionStream | DecompressionStream,
): ReadableStream<Uint8Array> {
  return new Blob([bytes]).stream().pipeThrough(transform)
}

async function collect(stream: ReadableStream<Uint8Array>, most: number): Promise<Uint8Array> {
  const chunks: Uint8Array<ArrayBufferLike>[] = []
  let length = 0
  const reader = stream.getReader()
  for (;;) {
    const { done, value } = await reader.read()
    if (done) break
    length += value.length
    if (length > most) {
      void reader.cancel()
      throw new LinkError('link-too-large', `The link unfolds to more than ${most} bytes.`)
    }
    chunks.push(value)
  }
  const whole = new Uint8Array(length)
  let at = 0
  for (const chunk of chunks) {
    whole.set(chunk, at)
    at += chunk.length
  }
  return whole
}
