/** Links as they arrive: whatever writers, mail and chat have made of them, the same opens or the page says what is missing. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { inflateRawSync } from 'node:zlib'
import { expect, test } from '@playwright/test'
import { packBits, unpack } from '../../../www/src/share/codec'
import {
  type ComparisonLink,
  decodeFragment,
  encodeDocument,
} from '../../../www/src/share/comparison_link'
import { open, seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'
import { linkIn, textBehind } from '../../../www/src/share/link_in_text'
import { shareEnding } from '../../../www/src/share/share_of_class'
import { toldLength } from '../../../www/src/share/told_length'
import { generate, randomCells, sessionOf } from './sessions'

const ADDRESS = 'https://example.org/ants/'
/** Of each kind. */
const LINKS = 250

/** A fixed sequence below one, as good for one run as for another. */
function chances(seed: number): () => number {
  let state = seed
  return () => {
    state = (state * 48271) % 2147483647
    return state / 2147483647
  }
}

/** What a link opens as, or why it does not. */
type Opened = { same: string } | LinkError

interface Sent {
  link: string
  /** What is opened when nothing is lost. */
  content: string
  open: (address: string) => Promise<Opened>
}

const orError = (opened: Promise<unknown>): Promise<Opened> =>
  opened.then(
    (value) => ({ same: JSON.stringify(value) }),
    (error: unknown) => {
      if (error instanceof LinkError) return error
      throw error
    },
  )

/** What is opened follows from the link that is found, so each of them is unpacked once. */
function once(open: (link: string) => Promise<Opened>): (address: string) => Promise<Opened> {
  const known = new Map<string, Promise<Opened>>()
  return (address) => {
    const link = linkIn(address) ?? address
    const opened = known.get(link) ?? open(link)
    known.set(link, opened)
    return opened
  }
}

const openSession = (address: string) =>
  orError(open(textBehind('#x=', address, 'session')).then((bytes) => unpack(bytes, generate)))

async function sessionLink(seed: number): Promise<Sent> {
  const chance = chances(seed)
  const [width, height] = [2 + Math.floor(chance() * 30), 2 + Math.floor(chance() * 30)]
  const cells = randomCells(width, height, chance())
  const session = { ...sessionOf(width, height, cells), seed, title: `Race ${seed}` }
  const packed = packBits(session, '0.1.0')
  const content = JSON.stringify(await unpack(packed, generate))
  return { link: `#x=${await seal(packed)}`, content, open: once(openSession) }
}

async function comparisonLink(seed: number): Promise<Sent> {
  const chance = chances(seed)
  const noise = Array.from({ length: 20 + chance() * 90 }, () => Math.floor(chance() * 1e6))
  const document = JSON.stringify({ format: 'formicarium/comparison@1', noise })
  const of = 1 + Math.floor(chance() * 40)
  const share = [undefined, { index: null, of }, { index: of, of }][seed % 3]
  const carried: ComparisonLink = { document, numbers: null, ...(share && { share }) }
  const link = `#q=${await encodeDocument(document)}${share ? shareEnding(share) : ''}`
  return {
    link,
    content: JSON.stringify(carried),
    open: once((text) => orError(decodeFragment(text))),
  }
}

/** As it stands in mail that is quoted-printable. */
const quotedPrintable = (text: string) => text.replaceAll('=', '=3D').replace(/.{70}/g, '$&=\r\n')

const everySigns = (text: string, count: number, between: string) =>
  text.match(new RegExp(`.{1,${count}}`, 'g'))?.join(between) ?? ''

/** `#x=` and the text, and what stands behind it. */
function pieces(link: string): { text: string; ending: string } {
  const at = link.indexOf('&')
  return at < 0 ? { text: link, ending: '' } : { text: link.slice(0, at), ending: link.slice(at) }
}
const brokenBy = (between: string, count: number) => (link: string) => {
  const { text, ending } = pieces(link)
  return ADDRESS + everySigns(text.slice(3), count, between).replace(/^/, text.slice(0, 3)) + ending
}

const SIGNS = ['.', ',', ';', ':', '!', '?', ')', ']', '>', '"', "'", '”', '。', '，', '）', '》']

/** What leaves all characters in place. */
const HARMLESS: Record<string, (link: string) => string> = {
  'nothing at all': (link) => ADDRESS + link,
  'the fragment alone': (link) => link,
  ...Object.fromEntries(
    SIGNS.flatMap((sign) => [
      [`${sign} behind it`, (link: string) => ADDRESS + link + sign],
      [`${sign} behind it, as a code`, (link: string) => encodeURI(ADDRESS + link + sign)],
    ]),
  ),
  'several signs behind it': (link) => `(see <${ADDRESS}${link}>).`,
  'a sentence around it': (link) => `Look: ${ADDRESS}${link} and tell me`,
  'a sentence in the address': (link) => encodeURI(`${ADDRESS}${link} and tell me`),
  'a line break behind it': (link) => `${ADDRESS}${link}\r\n\r\nAda\r\n-- \r\nTel. 5`,
  'spaces around it': (link) => `  ${ADDRESS}${link} \u00a0`,
  'lines broken by mail': brokenBy('\r\n', 72),
  'lines broken and quoted': brokenBy('\n> > ', 60),
  'lines broken, in an address': brokenBy('%0D%0A', 72),
  'a space in its middle': brokenBy(' ', 100),
  'signs that nobody sees': brokenBy('\u200b', 30),
  'signs that nobody sees, as codes': brokenBy('%E2%80%8B', 30),
  'soft hyphens': brokenBy('\u00ad', 30),
  'places where HTML may break': brokenBy('<wbr>', 40),
  'quoted-printable': (link) => quotedPrintable(`Look: ${ADDRESS}${link}\r\n`),
  'a space of quoted-printable': (link) => `${ADDRESS}${link}=20\r\n`,
  '# as a code in the path': (link) => ADDRESS + link.replace('#', '%23'),
  '# and = as codes': (link) => ADDRESS + encodeURIComponent(link),
  'codes of codes in another address': (link) =>
    `https://safe.example/?url=${encodeURIComponent(encodeURIComponent(ADDRESS + link))}&data=05`,
  'an address within another': (link) =>
    `https://safe.example/?url=${encodeURIComponent(ADDRESS + link)}&data=05%7C02`,
  'a second #': (link) => `${ADDRESS}#${link}`,
  '- and _ as codes': (link) => ADDRESS + link.replaceAll('-', '%2D').replaceAll('_', '%5F'),
  'what tracks behind it': (link) => `${ADDRESS}${link}&utm_source=mail&utm_medium=x&fbclid=Iw-_0`,
  'what tracks, as a query': (link) => `${ADDRESS}${link}?utm_source=chat`,
  'what tracks before it': (link) => `${ADDRESS}?fbclid=IwAR${link}`,
  '& of HTML': (link) => (ADDRESS + link).replaceAll('&', '&amp;'),
  '# of HTML': (link) => (ADDRESS + link).replace('#', '&#35;'),
}

async function expectSame(sent: Sent, how: string, mangled: string) {
  const opened = await sent.open(mangled)
  expect('same' in opened ? opened.same : opened.message, `${how}: ${mangled}`).toBe(sent.content)
}

for (const [what, make] of [
  ['sessions', sessionLink],
  ['comparisons', comparisonLink],
] as const) {
  test(`links of ${LINKS} ${what} end in a letter or digit, know their length, and survive being sent`, async () => {
    test.setTimeout(400_000)
    for (let seed = 1; seed <= LINKS; seed++) {
      const sent = await make(seed)
      const { text } = pieces(sent.link)
      expect(sent.link).toMatch(/[A-Za-z0-9]$/)
      expect(text).toMatch(/[A-Za-z0-9]$/)
      expect(toldLength(text.slice(3))).toBe(text.length - 3)
      const all = Object.entries(HARMLESS)
      await Promise.all(all.map(([how, mangle]) => expectSame(sent, how, mangle(sent.link))))
    }
  })

  test(`links of ${LINKS} ${what} that lost characters say how many, and never open as anything else`, async () => {
    test.setTimeout(400_000)
    for (let seed = 1; seed <= LINKS; seed++) {
      const sent = await make(seed)
      const { text } = pieces(sent.link)
      const all = text.length - 3
      const lost = 1 + Math.floor(chances(seed + 7)() * (all - 60))
      const middle = 50 + Math.floor(chances(seed + 9)() * (all - lost - 50))
      const behind = `… and there is more to say: ${'so '.repeat(400)}`
      for (const [kept, gone] of [
        [text.slice(0, -1), 1],
        [text.slice(0, -lost), lost],
        [`${text.slice(0, -lost)}${behind}`, lost],
        [`${text.slice(0, -lost)}\n${behind}`, lost],
        [text.slice(0, middle) + text.slice(middle + lost), lost],
      ] as const) {
        const error = (await sent.open(ADDRESS + kept)) as LinkError
        expect(error, kept).toBeInstanceOf(LinkError)
        expect([error.kind, error.args], kept).toMatchObject([
          'link-cut',
          { missing: `${gone}`, all: `${all}` },
        ])
        expect(error.message).toContain(`${gone} of its ${all} characters`)
      }
    }
  })

  test(`links of ${LINKS} ${what} with another character in their middle say that they were changed`, async () => {
    for (let seed = 1; seed <= LINKS; seed++) {
      const sent = await make(seed)
      const { text } = pieces(sent.link)
      // Behind what tells the length, before the last character, whose last bits may mean nothing.
      const at = 30 + Math.floor(chances(seed)() * (text.length - 40))
      const other = text[at] === 'k' ? 'R' : 'k'
      const changed = await sent.open(ADDRESS + text.slice(0, at) + other + text.slice(at + 1))
      expect(changed, `${at} of ${text}`).toMatchObject({
        kind: expect.stringMatching(/^link-(changed|damaged)$/),
      })
    }
  })
}

test('every changed character in the beginning is refused, or changes nothing', async () => {
  const sent = await sessionLink(5)
  for (let at = 3; at < 60; at++) {
    for (const other of ['A', 'k', '-']) {
      const opened = await sent.open(sent.link.slice(0, at) + other + sent.link.slice(at + 1))
      if ('same' in opened) expect(opened.same).toBe(sent.content)
      else expect(opened.kind).toMatch(/^link-(changed|cut|damaged|too-large)$/)
    }
  }
})

test('pages of before open what is written today', async () => {
  for (let seed = 1; seed <= 50; seed++) {
    const sent = await sessionLink(seed)
    // As every version has read it: the first byte says how, the rest is unpacked.
    const sealed = Buffer.from(sent.link.slice(3), 'base64url')
    expect(sealed[0]).toBe(1)
    const session = await unpack(inflateRawSync(sealed.subarray(1)), generate)
    expect(JSON.stringify(session)).toBe(sent.content)
  }
})

test.describe('links of before, which do not know their length', () => {
  const folder = join(__dirname, '../../fixtures/links')
  for (const path of ['b298a60/plane-one-goal', 'ae9355b/terrain-surface', '0.1.0/session']) {
    test(`${path} survives being sent, too`, async () => {
      const link = readFileSync(join(folder, `${path}.link`), 'utf8').trim()
      const whole = await openSession(link)
      const content = 'same' in whole ? whole.same : whole.message
      expect('same' in whole).toBe(true)
      expect(toldLength(link.slice(3))).toBeNull()
      for (const [how, mangle] of Object.entries(HARMLESS))
        await expectSame({ link, content, open: openSession }, how, mangle(link))
      expect(await openSession(link.slice(0, -9))).toMatchObject({ kind: 'link-damaged' })
    })
  }
})
