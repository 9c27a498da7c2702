/** Title, note, labels and what was looked at, in links and files. */
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { isNote, isOneLine, LONGEST, noteText, oneLine } from '../../../www/src/model/names'
import type { Session } from '../../../www/src/model/session'
import { packBits, unpack } from '../../../www/src/share/codec'
import { open, seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'
import { documentOf, readDocument } from '../../../www/src/share/session_document'
import { builtInCalled } from '../../../www/src/words/built_in_names'
import { generate, rolling, sessionOf, terrainOf } from './sessions'

const ROOT = join(__dirname, '../../..')
const LINKS = join(ROOT, 'tests/fixtures/links')

function worded(): Session {
  const session = sessionOf(8, 4)
  const [first, ...others] = session.panels
  if (!first) throw new Error('there is no panel')
  return {
    ...session,
    panels: [{ ...first, label: 'Langsame Ameisen 慢' }, ...others],
    title: 'Why <b>evaporation</b> matters',
    note: 'Look at the corridor.\n\n\tThen try ρ = 0.3 & more.',
    look: 12,
    inspected: { panel: 1, cell: [3, 2], level: null },
  }
}

const pass = async (session: Session) =>
  unpack(await open(await seal(packBits(session, '0.1.0'))), generate)

// biome-ignore lint/suspicious/noExplicitAny: a document that is to be spoilt has no type
type Document = any

function refusal(change: (document: Document) => void, of = worded()): LinkError {
  const document = JSON.parse(JSON.stringify(documentOf(of, '0.1.0')))
  change(document)
  try {
    readDocument(document)
  } catch (error) {
    if (error instanceof LinkError) return error
  }
  throw new Error('it was accepted')
}

test.describe('what a session says beside its race', () => {
  test('comes back from a link', async () => {
    const session = worded()
    expect(await pass(session)).toEqual(session)
  })

  test('by slices with a level', async () => {
    const session = terrainOf(8, 4, rolling(8, 4, 10))
    session.scenario.spec.terrain = {
      vertical_unit: 1,
      slices: {
        level: 1,
        levels: 12,
        max_aside: 1,
        max_climb: 1,
        start_level: 6,
        goal_level: 6,
        measure: 'cost',
      },
    }
    session.look = 0
    session.inspected = { panel: 0, cell: [7, 3], level: 12 }
    expect(await pass(session)).toEqual(session)
    expect(refusal((d) => (d.inspected.level = 13), session).field).toBe('inspected.level')
  })

  test('of a map that has shrunk, or whose levels are gone, is left out', async () => {
    const session = worded()
    session.inspected = { panel: 1, cell: [7, 3], level: 4 }
    expect((await pass(session)).inspected).toEqual({ panel: 1, cell: [7, 3], level: null })
    session.inspected = { panel: 1, cell: [8, 3], level: null }
    expect((await pass(session)).inspected).toBeNull()
  })

  test('is left out where there is nothing to say', () => {
    const document = documentOf(sessionOf(8, 4), '0.1.0')
    expect(Object.keys(document)).toEqual([
      'format',
      'engine',
      'scenario',
      'panels',
      'seed',
      'sync',
      'speed',
      'layer',
    ])
    for (const panel of document.panels as object[])
      expect(Object.keys(panel)).toEqual(['planner', 'preset', 'params', 'result'])
  })

  test('is refused by name', () => {
    const cases: [string, (document: Document) => void][] = [
      ['title', (d) => (d.title = 7)],
      ['title', (d) => (d.title = 'a'.repeat(LONGEST.title + 1))],
      ['title', (d) => (d.title = 'two\nlines')],
      ['note', (d) => (d.note = ['a'])],
      ['note', (d) => (d.note = 'a'.repeat(LONGEST.note + 1))],
      ['note', (d) => (d.note = 'bell \u0007')],
      ['panels[0].label', (d) => (d.panels[0].label = { text: 'a' })],
      ['panels[0].label', (d) => (d.panels[0].label = 'a'.repeat(LONGEST.label + 1))],
      ['panels[1].label', (d) => (d.panels[1].label = 'a\u2028b')],
      ['look', (d) => (d.look = -1)],
      ['look', (d) => (d.look = 1.5)],
      ['look', (d) => (d.look = '12')],
      ['inspected', (d) => (d.inspected = 3)],
      ['inspected.panel', (d) => (d.inspected.panel = 2)],
      ['inspected.cell[0]', (d) => (d.inspected.cell = [8, 0])],
      ['inspected.level', (d) => (d.inspected.level = 1)],
    ]
    for (const [field, change] of cases) {
      const error = refusal(change)
      expect([error.kind, error.field]).toEqual(['link-invalid', field])
    }
  })

  test('null and blank are nothing; what is not known is passed over', () => {
    const document = JSON.parse(JSON.stringify(documentOf(sessionOf(8, 4), '0.1.0')))
    Object.assign(document, {
      title: null,
      note: '  \r\n ',
      look: null,
      inspected: null,
      mood: 'good',
    })
    document.panels[0].label = '   '
    document.panels[0].colour = 'red'
    const { scenario: _, ...rest } = sessionOf(8, 4)
    expect(readDocument(document)).toMatchObject(rest)
    expect(readDocument(document)).not.toHaveProperty('mood')
  })

  test('of a script that knows nothing of it may be missing', () => {
    const { title, note, look, inspected, panels, ...bare } = sessionOf(8, 4)
    const older = { ...bare, panels: panels.map(({ label, ...panel }) => panel) } as Session
    const { scenario: _, ...rest } = { ...older, panels, title, note, look, inspected }
    expect(readDocument(JSON.parse(JSON.stringify(documentOf(older, ''))))).toMatchObject(rest)
  })
})

test.describe('links of before', () => {
  const samples = readdirSync(LINKS, { recursive: true, encoding: 'utf8' }).filter(
    (path) => path.endsWith('.link') && !path.includes('study'),
  )

  for (const path of samples) {
    test(`${path} says nothing of it, and keeps its bytes when it is written again`, async () => {
      const text = readFileSync(join(LINKS, path), 'utf8').trim().replace('#x=', '')
      const bytes = await open(text)
      const session = await unpack(bytes, generate)
      expect(session).toMatchObject({ title: '', note: '', look: null, inspected: null })
      expect(session.panels.map(({ label }) => label)).toEqual(session.panels.map(() => null))
      // Goals had no weights then, which are written today.
      if (path.startsWith('b298a60')) return
      const again = packBits(session, '0.1.0')
      expect(Buffer.from(again).toString('hex')).toBe(Buffer.from(bytes).toString('hex'))
    })
  }
})

test.describe('what is typed', () => {
  test('as one line: trimmed, without control characters, not too long', () => {
    expect(oneLine('  a\tb\r\nc\u2028d  ', 60)).toBe('a b  c d')
    expect(oneLine('   ', 60)).toBe('')
    expect(oneLine(`${'a'.repeat(59)} b`, 60)).toBe('a'.repeat(59))
    expect(isOneLine(oneLine('a\u0000\u007f\u0085b', 60))).toBe(true)
  })

  test('as a note keeps its line breaks, whatever system made them', () => {
    expect(noteText('\n a\r\nb\rc\u2029\td \n')).toBe('a\nb\nc\n\td')
    expect(noteText('a\u0007b')).toBe('a b')
    expect(noteText('a'.repeat(3000))).toHaveLength(LONGEST.note)
    expect(isNote('a\r')).toBe(false)
  })
})

test('every built-in map is known by the name in its file', () => {
  const read = (path: string) => readFileSync(join(ROOT, path), 'utf8')
  const gallery = read('www/src/gallery/gallery.ts')
  const drawn = [...gallery.matchAll(/(?:drawn|generated|specOf)\('([^']+)'/g)].map(
    ([, name]) => name,
  )
  const files = [...read('www/src/gallery/paper_maps.ts').matchAll(/file: '([^']+)'/g)].map(
    ([, file]) => JSON.parse(read(`experiments/maps/${file}.json`)).name,
  )
  const ids = [...`${gallery}${read('www/src/gallery/paper_maps.ts')}`.matchAll(/ id: '([^']+)'/g)]
  const known = [...drawn, ...files].map((name) => builtInCalled(name ?? ''))
  expect(known.toSorted()).toEqual(ids.map(([, id]) => id).toSorted())
  expect(builtInCalled('constructor')).toBeUndefined()
})
