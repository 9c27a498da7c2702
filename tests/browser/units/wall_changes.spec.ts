/** Changes of walls in sessions: what is written, what is read again, and what is refused. */
import { expect, test } from '@playwright/test'
import type { Session, WallChange } from '../../../www/src/model/session'
import { changed, scenarioBefore, wallsBetween } from '../../../www/src/model/wall_changes'
import { packBits, packEdits, unpack } from '../../../www/src/share/codec'
import { afterChanges } from '../../../www/src/share/session_changes'
import { documentOf, readDocument } from '../../../www/src/share/session_document'
import { generate, sessionOf } from './sessions'

const first: WallChange = {
  blocked: [
    [3, 1],
    [3, 2],
  ],
  freed: [],
  at: [12, 5],
}
const second: WallChange = { blocked: [[4, 4]], freed: [[3, 2]], at: [30, 5] }

/** A session on a map of 8 × 6, free but for what its changes block. */
function changedSession(): Session {
  const session = sessionOf(8, 6, new Uint8Array(48))
  const { scenario } = session
  const cells = [first, second].reduce<Uint8Array>(
    (map, change) => changed(map, 8, change),
    scenario.cells,
  )
  return {
    ...session,
    scenario: { ...scenario, cells },
    changes: [first, second],
    keepTrails: true,
  }
}

interface Written {
  format: string
  keep_trails?: unknown
  scenario: { changes: Record<string, unknown>[] }
}

/** What a reader makes of the session's document with something else in it. */
function spoiled(spoil: (document: Written) => void): void {
  const document = JSON.parse(JSON.stringify(documentOf(changedSession(), '0.1.0'))) as Written
  spoil(document)
  const { spec, changes = [] } = readDocument(document)
  afterChanges(
    { spec, cells: new Uint8Array(48), heights: null, factors: null, origin: null },
    changes,
  )
}

test('a link brings back the changes and the map as they left it', async () => {
  const session = changedSession()
  expect(await unpack(packBits(session, '0.1.0'), generate)).toEqual(session)
})

test('a generated map with changes travels as its generator call', async () => {
  const origin = { generator: 'random', seed: 3, density: 0 } as const
  const base = changedSession()
  const made = await generate(origin, 8, 6)
  const cells = made.cells.slice()
  for (const { blocked, freed } of [first, second])
    for (const [x, y] of [...blocked, ...freed]) cells[y * 8 + x] = 0
  const after = [first, second].reduce<Uint8Array>((map, change) => changed(map, 8, change), cells)
  const session = { ...base, scenario: { ...base.scenario, cells: after, origin } }
  const packed = await packEdits(session, '0.1.0', generate)
  expect(packed && (await unpack(packed, generate))).toEqual(session)
})

test('the document says in its version that walls change, and the map before it travels', () => {
  const session = changedSession()
  expect(documentOf(session, '0.1.0').format).toBe('formicarium/experiment@2')
  expect(scenarioBefore(session).cells).toEqual(new Uint8Array(48))
})

test('a session without changes is written as ever', () => {
  const { changes: _, keepTrails: __, ...plain } = changedSession()
  const written = JSON.stringify(documentOf(plain, '0.1.0'))
  expect(written).toContain('formicarium/experiment@1')
  expect(written).not.toMatch(/changes|keep_trails/)
})

test('the choice alone needs no new version', async () => {
  const { changes: _, ...chosen } = changedSession()
  expect(documentOf(chosen, '0.1.0').format).toBe('formicarium/experiment@1')
  expect(await unpack(packBits(chosen, '0.1.0'), generate)).toEqual(chosen)
})

const REFUSED: [string, (document: Written) => void, string][] = [
  ['version 1 with changes', (d) => (d.format = 'formicarium/experiment@1'), 'scenario.changes'],
  ['version 2 without', (d) => Reflect.deleteProperty(d.scenario, 'changes'), 'scenario.changes'],
  ['an empty list', (d) => (d.scenario.changes = []), 'scenario.changes'],
  ['another version', (d) => (d.format = 'formicarium/experiment@4'), 'format'],
  [
    'a wall that is there',
    (d) => change(d, 1, { blocked: [[3, 1]] }),
    'scenario.changes[1].blocked[0]',
  ],
  ['the start', (d) => change(d, 0, { blocked: [[0, 0]] }), 'scenario.changes[0].blocked[0]'],
  ['a goal', (d) => change(d, 0, { blocked: [[7, 5]] }), 'scenario.changes[0].blocked[0]'],
  ['outside', (d) => change(d, 0, { blocked: [[8, 0]] }), 'scenario.changes[0].blocked[0][0]'],
  [
    'twice',
    (d) =>
      change(d, 0, {
        blocked: [
          [1, 1],
          [1, 1],
        ],
      }),
    'scenario.changes[0].blocked[1]',
  ],
  ['free already', (d) => change(d, 0, { freed: [[1, 1]] }), 'scenario.changes[0].freed[0]'],
  ['no cell', (d) => change(d, 0, { blocked: [] }), 'scenario.changes[0]'],
  ['a number too few', (d) => change(d, 0, { at: [12] }), 'scenario.changes[0].at'],
  ['back in time', (d) => change(d, 1, { at: [11, 5] }), 'scenario.changes[1].at[0]'],
  ['half an iteration', (d) => change(d, 0, { at: [1.5, 5] }), 'scenario.changes[0].at[0]'],
  ['a choice that is none', (d) => (d.keep_trails = 'yes'), 'keep_trails'],
]

function change(document: Written, index: number, fields: Record<string, unknown>): void {
  document.scenario.changes[index] = { ...document.scenario.changes[index], ...fields }
}

for (const [what, spoil, field] of REFUSED) {
  test(`refused by name: ${what}`, () => {
    expect(() => spoiled(spoil)).toThrow(expect.objectContaining({ field }))
  })
}

test('what leads from one map to another is told row by row', () => {
  const before = Uint8Array.from([0, 1, 0, 1])
  expect(wallsBetween(before, Uint8Array.from([1, 0, 0, 1]), 2)).toEqual({
    blocked: [[0, 0]],
    freed: [[1, 0]],
  })
})
