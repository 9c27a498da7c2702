import { crc32, deflateSync, inflateSync } from 'node:zlib'
import { expect, test } from '@playwright/test'
import { LinkError } from '../../../www/src/share/link_error'
import { isPng, pngWith, textOfPng } from '../../../www/src/share/png'

const SIGNATURE = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10])

function chunk(kind: string, data: Buffer): Buffer {
  const covered = Buffer.concat([Buffer.from(kind, 'latin1'), data])
  const frame = Buffer.alloc(8)
  frame.writeUInt32BE(data.length, 0)
  frame.writeUInt32BE(crc32(covered), 4)
  return Buffer.concat([frame.subarray(0, 4), covered, frame.subarray(4)])
}

/** A black pixel: 1 × 1, eight bits of grey. */
const PIXEL = Buffer.concat([
  SIGNATURE,
  chunk('IHDR', Buffer.from([0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0])),
  chunk('IDAT', deflateSync(Buffer.from([0, 0]))),
  chunk('IEND', Buffer.alloc(0)),
])

/** Kinds and data of all chunks, read with node's own tools; a wrong CRC is an error. */
function chunksOf(png: Uint8Array): [string, Buffer][] {
  const bytes = Buffer.from(png)
  const found: [string, Buffer][] = []
  for (let at = 8; at < bytes.length; ) {
    const length = bytes.readUInt32BE(at)
    const covered = bytes.subarray(at + 4, at + 8 + length)
    expect(bytes.readUInt32BE(at + 8 + length)).toBe(crc32(covered))
    found.push([covered.toString('latin1', 0, 4), covered.subarray(4)])
    at += 12 + length
  }
  return found
}

async function refusal(png: Uint8Array): Promise<string> {
  const error = await textOfPng(png).then(
    () => null,
    (thrown: unknown) => thrown,
  )
  expect(error).toBeInstanceOf(LinkError)
  return (error as LinkError).kind
}

const TEXT = `{"title": "蚁群 – Größe", "rows": [${'0,'.repeat(20_000)}1]}`

test.describe('texts in pictures', () => {
  test('a picture carries a text as other programs read it', async () => {
    const png = await pngWith(PIXEL, TEXT)
    expect(isPng(png)).toBe(true)
    const chunks = chunksOf(png)
    expect(chunks.map(([kind]) => kind)).toEqual(['IHDR', 'iTXt', 'IDAT', 'IEND'])
    const data = chunks[1]?.[1] ?? Buffer.alloc(0)
    // Keyword, compressed by zlib, no language, no translated keyword.
    expect(data.subarray(0, 16).toString('latin1')).toBe('formicarium\0\x01\0\0\0')
    expect(inflateSync(data.subarray(16)).toString('utf8')).toBe(TEXT)
    expect(png.length).toBeLessThan(PIXEL.length + 500)
    expect(await textOfPng(png)).toBe(TEXT)
  })

  test('a text replaces the one before it and no other', async () => {
    const other = chunk('iTXt', Buffer.from('Comment\0\0\0\0\0by somebody else', 'utf8'))
    const [head, rest] = [PIXEL.subarray(0, 33), PIXEL.subarray(33)]
    const once = await pngWith(Buffer.concat([head, other, rest]), 'one')
    const twice = await pngWith(once, 'two')
    expect(chunksOf(twice).map(([kind]) => kind)).toEqual(['IHDR', 'iTXt', 'iTXt', 'IDAT', 'IEND'])
    expect(await textOfPng(twice)).toBe('two')
    expect(Buffer.from(twice).includes('by somebody else')).toBe(true)
  })

  test('a text that another program wrote without compression is read', async () => {
    const plain = chunk('iTXt', Buffer.from('formicarium\0\0\0en\0Ameisen\0#q=蚁', 'utf8'))
    const png = Buffer.concat([PIXEL.subarray(0, 33), plain, PIXEL.subarray(33)])
    expect(await textOfPng(png)).toBe('#q=蚁')
  })

  test('a picture without one says so', async () => {
    expect(await refusal(PIXEL)).toBe('picture-bare')
    expect(await refusal(SIGNATURE)).toBe('picture-bare')
    // Cut before its text ends.
    const png = await pngWith(PIXEL, TEXT)
    expect(await refusal(png.subarray(0, 60))).toBe('picture-bare')
  })

  test('a text that was changed is never shown', async () => {
    const png = await pngWith(PIXEL, TEXT)
    for (let at = 33 + 8 + 12; at < 33 + 8 + 60; at += 3) {
      const spoilt = Uint8Array.from(png)
      spoilt[at] = (spoilt[at] ?? 0) ^ 4
      expect(await refusal(spoilt), `byte ${at}`).toBe('link-damaged')
    }
    const nonsense = chunk('iTXt', Buffer.from('formicarium\0\x01\0\0\0not zlib', 'latin1'))
    expect(await refusal(Buffer.concat([SIGNATURE, nonsense]))).toBe('link-damaged')
    const unknown = chunk('iTXt', Buffer.from('formicarium\0\x01\x07\0\0x', 'latin1'))
    expect(await refusal(Buffer.concat([SIGNATURE, unknown]))).toBe('link-damaged')
    const short = chunk('iTXt', Buffer.from('formicarium\0\x01', 'latin1'))
    expect(await refusal(Buffer.concat([SIGNATURE, short]))).toBe('link-damaged')
  })

  test('a picture of nothing but empty chunks is refused at once', async () => {
    const empty = chunk('tEXt', Buffer.alloc(0))
    const picture = Buffer.concat([PIXEL.subarray(0, 33), Buffer.alloc(63_000_000, empty)])
    const began = performance.now()
    expect(await refusal(picture)).toBe('link-damaged')
    expect(performance.now() - began).toBeLessThan(500)
    // What stands before the many is found without looking at them.
    const added = Buffer.concat([await pngWith(PIXEL, TEXT), picture.subarray(33)])
    expect(await textOfPng(added)).toBe(TEXT)
    const many = Buffer.concat([PIXEL.subarray(0, 33), Buffer.alloc(8192 * 12, empty)])
    expect(await textOfPng(await pngWith(many, 'one'))).toBe('one')
  })
})
