import { expect, test } from '@playwright/test'
import { varint } from '../../../www/src/share/byte_stream'
import { withChecksum } from '../../../www/src/share/codec'
import { decodeFragment, encodeDocument, PREFIX } from '../../../www/src/share/comparison_link'
import { open as openSealed, seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'
import { checkNumbers } from '../../../www/src/share/recorded_numbers'

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
      const opened = await decodeFragment(`https://example.org/lab/${PREFIX}${text}`)
      expect(opened).toEqual({ document, numbers: null })
    }
  })

  test('tell what came out behind the document, where earlier pages do not look', async () => {
    const told = { runs: 30, withPath: 29, best: 33.89949493, median: 34.5, gap: 0.0177 }
    const none = { runs: 3, withPath: 0, best: null, median: null, gap: null }
    const numbers = [
      [told, null],
      [none, { ...told, best: 30, gap: 0 }],
    ]
    const whole = await encodeDocument(DOCUMENT, numbers)
    const opened = await decodeFragment(PREFIX + whole)
    expect(opened.document).toBe(DOCUMENT)
    expect(opened.numbers).toEqual([[{ ...told, best: 33.89949 }, null], numbers[1]])
    // What stands before them is the link without them, but for the check sum.
    const [before, after] = await Promise.all(
      [await encodeDocument(DOCUMENT), whole].map((text) => openSealed(text)),
    )
    expect(after?.subarray(4, before?.length)).toEqual(before?.subarray(4))
  })

  test('with numbers that are none are refused by name', async () => {
    const json = [...new TextEncoder().encode(DOCUMENT)]
    const given = async (text: string) => {
      const told = [...new TextEncoder().encode(text)]
      return refusal(
        await link([1, ...varint(json.length), ...json, ...varint(told.length), ...told]),
      )
    }
    expect(await given('{')).toBe('link-damaged')
    for (const wrong of [
      '{}',
      '[1]',
      '[[[1,1,2,2]]]',
      '[[[0,0,null,null,null]]]',
      '[[[2,3,1,1,0]]]',
      '[[[2,2,-1,1,0]]]',
      '[[[2,2,1,"1",0]]]',
      '[[[2.5,2,1,1,0]]]',
    ])
      expect(await given(wrong), wrong).toBe('link-invalid')
    const question = { instances: Array(1), entries: Array(2) }
    expect(() => checkNumbers([[null, null]], question)).not.toThrow()
    for (const numbers of [
      [],
      [[null]],
      [
        [null, null],
        [null, null],
      ],
    ])
      expect(() => checkNumbers(numbers, question)).toThrow(LinkError)
  })

  test('are short where documents repeat themselves', async () => {
    expect((await encodeDocument(DOCUMENT.repeat(500))).length).toBeLessThan(1000)
  })

  test('a character that was changed is never taken for another document', async () => {
    const text = await encodeDocument(DOCUMENT)
    for (let at = 0; at < text.length - 1; at++) {
      const other = text[at] === 'Q' ? 'R' : 'Q'
      const spoilt = `${PREFIX}${text.slice(0, at)}${other}${text.slice(at + 1)}`
      const opened = await decodeFragment(spoilt).catch((error: unknown) => error as LinkError)
      // Bits that deflate does not look at may change: then the document is the same.
      const isSame = 'document' in opened && opened.document === DOCUMENT
      const told = at < 30 ? /^link-(damaged|cut|changed)$/ : /^link-changed$/
      if (!isSame) expect('kind' in opened && opened.kind, `at ${at}`).toMatch(told)
    }
    expect(await refusal(`${PREFIX}${text.slice(0, -5)}`)).toBe('link-cut')
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
