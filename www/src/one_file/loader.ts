/**
 * Begins the page that is one file: unpacks its parts and starts it. It stands before them, so that it is there to tell when a file
 * ends too early. `one_file_shell.ts` writes it into the page.
 */
import { XzReadableStream } from 'xz-decompress'
import { unpackingEn } from '../i18n/en/unpacking'
import { unpackingZhCN } from '../i18n/zh_cn/unpacking'

const words = /^zh([-_]|$)/i.test(navigator.language) ? unpackingZhCN : unpackingEn

const place = document.getElementById('unpacking')
const self = document.currentScript

function tell(text: string): void {
  if (place) place.textContent = text
}

/** Why the page cannot begin, in words for who has opened the file. */
class Refusal extends Error {}

const written = place?.textContent ?? ''
tell(words.unpacking)
addEventListener('DOMContentLoaded', () => {
  // Said already (before_all.js).
  if (document.documentElement.dataset.lacks) return place?.remove()
  // The file as it was opened: from now on the document is the page's.
  tell(written)
  const html = `<!DOCTYPE html>\n${document.documentElement.outerHTML}`
  tell(words.unpacking)
  start(html).catch((error: unknown) =>
    tell(error instanceof Refusal ? error.message : `${words.failed} ${error}`),
  )
})

async function start(html: string): Promise<void> {
  const packed = packedText()
  const { textContent: carried = '', dataset } = element('carried')
  const parts = partsIn(await unpacked(packed))
  const { title } = document
  const from = dataset.from ?? ''
  globalThis.formicariumFile = { html, title, carried: carried ?? '', from, parts }
  addEventListener('error', tellWhileEmpty)
  addElement('style', textOf(parts, 'page.css'))
  addElement('script', textOf(parts, 'page.js'))
}

/** An empty one where the file ends before it. */
const element = (id: string) => document.getElementById(id) ?? document.createElement('script')

/** Throws where the file ends too early. */
function packedText(): string {
  const text = element('packed').textContent ?? ''
  const whole = Number(self?.dataset.characters)
  if (text.length === whole) return text
  throw new Refusal(
    words.cut.replace('{{there}}', String(text.length)).replace('{{whole}}', String(whole)),
  )
}

async function unpacked(text: string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    const stream = new XzReadableStream(new Blob([bytesOf(text)]).stream())
    return new Uint8Array(await new Response(stream).arrayBuffer())
  } catch (error) {
    throw new Refusal(words.damaged.replace('{{why}}', String(error)))
  }
}

/** What does not stand among the characters from ! to ~: it means something in a page, or in a program. */
const LEFT_OUT = '&<\\'

/**
 * Two characters are 13 bits, highest first: a number in two digits to the base 91 (xtask/src/one_file.rs writes them). The bytes are a
 * multiple of four.
 */
function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const digits = new Uint8Array(128)
  let digit = 0
  for (let code = '!'.charCodeAt(0); digit < 91; code++)
    if (!LEFT_OUT.includes(String.fromCharCode(code))) digits[code] = digit++
  const of = (at: number) => digits[text.charCodeAt(at)] ?? 0
  const bytes = new Uint8Array(Math.floor((text.length * 13) / 64) * 4)
  let waiting = 0
  let count = 0
  let end = 0
  for (let at = 0; at < text.length; at += 2) {
    waiting = (waiting << 13) | (of(at) * 91 + of(at + 1))
    for (count += 13; count >= 8; ) {
      count -= 8
      bytes[end++] = waiting >> count
    }
    waiting &= (1 << count) - 1
  }
  return bytes
}

/** See `one_file_shell.ts`: the length of a list, the list of names and lengths, the parts. */
function partsIn(bytes: Uint8Array<ArrayBuffer>): Map<string, Uint8Array<ArrayBuffer>> {
  const length = new DataView(bytes.buffer).getUint32(0, true)
  const list: [string, number][] = JSON.parse(decoded(bytes.subarray(4, 4 + length)))
  const parts = new Map<string, Uint8Array<ArrayBuffer>>()
  let at = 4 + length
  for (const [name, size] of list) {
    parts.set(name, bytes.subarray(at, at + size))
    at += size
  }
  return parts
}

const decoded = (bytes: Uint8Array) => new TextDecoder().decode(bytes)

/** The text of a part that is needed once. */
function textOf(parts: Map<string, Uint8Array>, name: string): string {
  const part = parts.get(name)
  parts.delete(name)
  return part ? decoded(part) : ''
}

function addElement(kind: 'style' | 'script', text: string): void {
  const element = document.createElement(kind)
  if (kind === 'script') element.setAttribute('type', 'module')
  element.textContent = text
  document.head.append(element)
}

/** The line is hidden as soon as the page has drawn itself: until then it says what goes wrong. */
function tellWhileEmpty({ message }: ErrorEvent): void {
  tell(`${words.failed} ${message}`)
}
