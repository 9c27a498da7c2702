import { expect, test } from '@playwright/test'
import { varint } from '../../../www/src/share/byte_stream'
import { withChecksum } from '../../../www/src/share/codec'
import { decodeFragment, encodeDocument, PREFIX } from '../../../www/src/share/comparison_link'
import { seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'

const DOCUMENT = `{"format": "formicarium/comparison@1", "question": {"title": "港 “Süd”"}, "maps": []}\n`

async function refusal(text: string): Promise<string> {
  const error = await decodeFragment(text).then(
    () => null,
    (thrown: unknown) => thrown,
  )
  expect(error).toBeInstanceOf(LinkError)
  return (error as LinkError).kind
}

/** A container with these bytes after its checksum. */
const link = async (bytes: number[]) => PREFIX + (await seal(withChecksum([bytes])))

test.describe('links to comparisons', () => {
  test('carry the document, byte for byte', async () => {
    for (const document of [DOCUMENT, '', DOCUMENT.repeat(500)]) {
      const text = await encodeDocument(document)
      expect(text).toMatch(/^[A-Za-z0-9_-]+$/)
      expect(await decodeFragment(`https://example.org/lab/${PREFIX}${text}`)).toBe(document)
    }
  })

  test('are short where documents repeat themselves', async () => {
    expect((await encodeDocument(DOCUMENT.repeat(500))).length).toBeLessThan(1000)
  })

  test('a character that was changed is never taken for another document', async () => {
    const text = await encodeDocument(DOCUMENT)
    for (let at = 0; at < text.length - 1; at++) {
      const other = text[at] === 'Q' ? 'R' : 'Q'
      const spoilt = `${PREFIX}${text.slice(0, at)}${other}${text.slice(at + 1)}`
      const opened = await decodeFragment(spoilt).catch((error: unknown) => error)
      // Bits that deflate does not look at may change: then the document is the same.
      if (opened !== DOCUMENT) expect((opened as LinkError).kind, `at ${at}`).toBe('link-damaged')
    }
    expect(await refusal(`${PREFIX}${text.slice(0, -5)}`)).toBe('link-damaged')
    expect(await refusal(PREFIX)).toBe('link-damaged')
  })

  test('of another kind or version are told apart', async () => {
    expect(await refusal('#x=AAAA')).toBe('link-foreign')
    expect(await refusal('#section-3')).toBe('link-foreign')
    expect(await refusal(await link([2, ...varint(0)]))).toBe('link-newer')
    expect(await refusal(await link([0, ...varint(0)]))).toBe('link-damaged')
    expect(await refusal(await link([1, ...varint(4), 123]))).toBe('link-damaged')
    expect(await refusal(await link([1, 1, 255]))).toBe('link-damaged')
  })
})
