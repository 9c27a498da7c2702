import { expect, test } from '@playwright/test'
import type { Session } from '../../../www/src/model/session'
import { bitsOf } from '../../../www/src/share/byte_stream'
import { MAX_BYTES, packBits, packEdits, unpack, withChecksum } from '../../../www/src/share/codec'
import { open, seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'
import { generate, randomCells, sessionOf } from './sessions'

const encode = (session: Session) => seal(packBits(session, '0.1.0'))
/** A container after its checksum: the version comes first. */
const covered = (session: Session) => packBits(session, '0.1.0').subarray(4)
const decode = async (text: string) => unpack(await open(text), generate)

/** `sessionOf(8, 4)` as version 0.1.0 wrote it, when goals had a place and a name only. Must stay readable for ever. */
const OLD_LINK =
  'AVWRv47TQBDGRXEFV_MA0Vdvgu04cbIVJT1lFEUbe2KvZO9as-tAFFm6kgbxAvAMtBR0vMkV9wxXojGcFLpZze7357f3z19fv_pyd8XJc2ci9DTY0rAdurf0qSe2Hbn4LoUCudo6gkaySBcJFEJJzrD10Fc408nqveGjH3j2-PDtw-9f1ePD99nTzx9Q-Gir2EBvFBqydROhcwWm4NshWu-gk8VKofNnEj9RlDlML0rPjvjAQysW3tH8xEQYFUI0HKF3iUr2CrU3bYDeXSFVdoVa7tVLsCNxbDDuFc7U2FKUrgg9UQWdinWg0rsqHHriQxx4SpStxlGhN47-6fatcY4YGsbFebiESB0UeqZAEz3LJGfDpgviYFwM0KtEgRsvkkuFikx1IFdBgykymShwWxttiNCRBxonNEM7cbCR2AijAJ1nU-c4BHk8OGddDYWWXC10l5vFtkhW66zIN3lRpMu1QmVrEl0kabbMV-tiszXHsqITxlH910hg3pRxQ9veVLnJJBshGSZ6ebbNt-si2wrEiyuhbyOrF8h__3OeriWvuUyWZxtslDud6eWP5DC--Ty7-wM'

// biome-ignore lint/suspicious/noExplicitAny: a document that is to be spoilt has no type
type Document = any

/** The document of a session, changed by hand and packed again. */
async function tampered(change: (document: Document) => void): Promise<string> {
  const bytes = covered(sessionOf(8, 4))
  const length = ((bytes[1] ?? 0) & 127) | ((bytes[2] ?? 0) << 7)
  const document = JSON.parse(new TextDecoder().decode(bytes.subarray(3, 3 + length)))
  change(document)
  const json = new TextEncoder().encode(JSON.stringify(document))
  const head = [1, (json.length & 127) | 128, json.length >> 7]
  return seal(withChecksum([head, json, bytes.subarray(3 + length)]))
}

async function refusal(text: string | Promise<string>): Promise<LinkError> {
  const error = await decode(await text).then(
    () => null,
    (thrown: unknown) => thrown,
  )
  expect(error).toBeInstanceOf(LinkError)
  return error as LinkError
}

test.describe('share codec', () => {
  for (const [width, height] of [
    [1, 2],
    [8, 8],
    [7, 13],
    [100, 100],
    [512, 512],
  ] as const) {
    test(`a session with a ${width} × ${height} map comes back unchanged`, async () => {
      const session = sessionOf(width, height)
      const text = await encode(session)
      expect(text).toMatch(/^[A-Za-z0-9_-]+$/)
      expect(await decode(text)).toEqual(session)
    })
  }

  test('several goals keep their names and weights, as far as there are', async () => {
    const session = sessionOf(30, 30)
    const [first] = session.scenario.spec.goals
    session.scenario.spec.goals = Array.from({ length: 64 }, (_, i) => ({
      at: [i % 30, 2 + Math.floor(i / 30)] as [number, number],
      name: i === 0 ? (first?.name ?? '') : `Feuer ${i} 火`,
      area: 0.25 + i,
      strength: 1.3,
      danger: 1 / 3,
    }))
    expect(await decode(await encode(session))).toEqual(session)
  })

  test('a link of before there were several goals is read: its goal has the weights 1', async () => {
    const opened = await decode(OLD_LINK)
    const expected = sessionOf(8, 4)
    expected.scenario.spec.goals = [{ at: [7, 3], name: 'berth', area: 1, strength: 1, danger: 1 }]
    expect(opened).toEqual(expected)
  })

  test('bits run row by row, most significant first', () => {
    expect([...bitsOf(Uint8Array.of(1, 0, 0, 0, 0, 0, 0, 1, 1))]).toEqual([0b10000001, 0b10000000])
  })

  test('a generated map with edits is stored as its generator call', async () => {
    const session = sessionOf(512, 512, randomCells(512, 512, 0.3))
    session.scenario.origin = { generator: 'random', seed: 5, density: 0.3 }
    for (const at of [0, 1, 77_777, 512 * 512 - 1]) {
      session.scenario.cells[at] = session.scenario.cells[at] === 1 ? 0 : 1
    }
    const packed = await packEdits(session, '0.1.0', generate)
    expect(packed).not.toBeNull()
    const text = await seal(packed ?? new Uint8Array())
    expect(text.length).toBeLessThan(1000)
    expect(await decode(text)).toEqual(session)
  })

  test('a generated map that was drawn over is not', async () => {
    const session = sessionOf(64, 64, new Uint8Array(64 * 64))
    session.scenario.origin = { generator: 'random', seed: 5, density: 0.9 }
    expect(await packEdits(session, '0.1.0', generate)).toBeNull()
  })

  test('a 100 × 100 map with 30 % walls fits a link, 512 × 512 does not', async () => {
    expect((await encode(sessionOf(100, 100))).length).toBeLessThan(2600)
    expect((await encode(sessionOf(512, 512))).length).toBeGreaterThan(8000)
  })
})

test.describe('links that cannot be opened', () => {
  test('every truncation is refused as one, never as anything else', async () => {
    const text = await encode(sessionOf(20, 20))
    for (let length = 0; length < text.length - 1; length += 7) {
      const { kind, message } = await refusal(text.slice(0, length))
      // With hardly anything left, the length is gone too.
      expect(kind).toMatch(length < 30 ? /^link-(damaged|cut)$/ : /^link-cut$/)
      if (length >= 30) expect(message).toContain(`${text.length - length} of its ${text.length}`)
    }
  })

  test('any one changed character is refused as damaged, or changes nothing', async () => {
    const session = sessionOf(20, 20)
    const text = await encode(session)
    let refused = 0
    for (let at = 0; at < text.length; at++) {
      const changed = text.slice(0, at) + (text[at] === 'A' ? 'B' : 'A') + text.slice(at + 1)
      const outcome = await decode(changed).catch((error: unknown) => error)
      if (!(outcome instanceof LinkError)) expect(outcome).toEqual(session)
      else {
        refused++
        // Unless it was the length that changed.
        expect(outcome.kind).toMatch(
          at < 30 ? /^link-(changed|cut|damaged)$/ : /^link-(changed|damaged)$/,
        )
      }
    }
    // The last bits of the text and of the packing mean nothing, and the length of a link that is whole; all others do.
    expect(refused).toBeGreaterThan(text.length - 5 - 4)
  })

  test('without packing, too, a changed character is damage, not a newer version', async () => {
    const bytes = packBits(sessionOf(4, 4), '0.1.0')
    for (let at = 0; at < bytes.length; at++) {
      const changed = bytes.slice()
      changed[at] = (changed[at] ?? 0) ^ 4
      expect((await refusal(seal(changed))).kind).toBe('link-changed')
    }
  })

  test('foreign text', async () => {
    for (const text of ['', '!!!!', 'hello world', '%%%', 'AAAA', '_'.repeat(50)]) {
      expect((await refusal(text)).kind).toBe('link-damaged')
    }
  })

  test('a newer container and a newer document say so', async () => {
    expect((await refusal(seal(withChecksum([[4, 0]])))).kind).toBe('link-newer')
    const newer = await refusal(
      tampered((document) => (document.format = 'formicarium/experiment@9')),
    )
    expect(newer.kind).toBe('link-newer')
    expect(newer.hint).toContain('Reload')
    expect((await refusal(tampered((document) => (document.format = 'other/thing@1')))).kind).toBe(
      'link-foreign',
    )
  })

  test('claimed sizes are refused before anything is allocated', async () => {
    const huge = await refusal(tampered(({ scenario }) => (scenario.width = 1e9)))
    expect(huge.kind).toBe('link-too-large')
    expect(huge.field).toBe('scenario.width')
    const crowd = await refusal(
      tampered((document) => (document.panels = Array(7).fill(document.panels[1]))),
    )
    expect(crowd.kind).toBe('link-too-large')
    const goals = await refusal(
      tampered(({ scenario }) => (scenario.goals = Array(65).fill(scenario.goals[0]))),
    )
    expect([goals.kind, goals.field]).toEqual(['link-too-large', 'scenario.goals'])
  })

  test('a payload that unfolds beyond all maps is cut off', async () => {
    const bomb = await seal(new Uint8Array(MAX_BYTES * 20))
    expect(bomb.length).toBeLessThan(200_000)
    expect((await refusal(bomb)).kind).toBe('link-too-large')
  })

  test('wrong values are refused by name', async () => {
    const cases: [string, (document: Document) => void][] = [
      ['seed', (d) => (d.seed = -1)],
      ['sync', (d) => (d.sync = 'sometimes')],
      ['speed', (d) => (d.speed = 'warp')],
      ['layer', (d) => (d.layer = 3)],
      ['scenario.start', (d) => (d.scenario.start = 'here')],
      ['scenario.start[0]', (d) => (d.scenario.start = [8, 0])],
      ['scenario.goals', (d) => (d.scenario.goals = [])],
      ['scenario.goals[0].at[1]', (d) => (d.scenario.goals[0].at = [0, 4])],
      ['scenario.goals[0].name', (d) => (d.scenario.goals[0].name = 7)],
      ['scenario.goals[0].area', (d) => (d.scenario.goals[0].area = 0)],
      ['scenario.goals[0].strength', (d) => (d.scenario.goals[0].strength = -1)],
      ['scenario.goals[0].danger', (d) => (d.scenario.goals[0].danger = 'much')],
      ['scenario.movement.moves', (d) => (d.scenario.movement.moves = 5)],
      ['panels[0].params.rho', (d) => (d.panels[0].params.rho = { bad: 1 })],
      ['panels[0].result.digest', (d) => (d.panels[0].result.digest = 'xyz')],
      ['map', (d) => (d.map = 'pictures')],
    ]
    for (const [field, change] of cases) {
      const error = await refusal(tampered(change))
      expect([error.kind, error.field]).toEqual(['link-invalid', field])
    }
  })
})
