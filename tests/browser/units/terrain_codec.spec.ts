import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import type { Session } from '../../../www/src/model/session'
import { joined, Reader } from '../../../www/src/share/byte_stream'
import { packNumbers, unpackNumbers } from '../../../www/src/share/cell_numbers'
import { packBits, packEdits, unpack, withChecksum } from '../../../www/src/share/codec'
import { open, seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'
import { generate, rolling, terrainOf } from './sessions'

const DATA = process.env.FORMICARIUM_DATA

const encode = (session: Session) => seal(packBits(session, '0.1.0'))
const decode = async (text: string) => unpack(await open(text), generate)

/** 4 × 3 surveyed heights as version 0.1.0 wrote them. Must stay readable for ever. */
const SURVEYED_LINK =
  'AVVSO2_UQBBOUIJoqGlPX7252D7faysKCmooo-g0Z098K9lra3Z9JDpZSkfLD4CWlpaCjt9Bk4L_QIfGJNLR7Wge32vffd3-efbr_ICbVhqKsOPDFSSuby75tmNxDfv4OoUB-8p5hkUyTacJDELBnsS1sAd4arT1lmTb9jJ5uP_8_ueP8uH-y-T3928w-ODKuIPNDXbsql2EnRkIh7buo2s9bDKdGzTtnhVPL-o7wK4MilY8y0b6WiFazxc3wozBIESSCHuVmOTaoGqpDrBXB6iUq5nJrs0TsS1L3MGAhAk201VhXymnEbkkX7HApsO1wZ53rlCwA0LHXMKmOhO4aH0ZNh3LJvYyks7mg0FkEXJe5_cs0RVUb3rvImxq0NDtJtRtx7DrZBgMOvL8yLOryXuFBfl4Ee5C5AYGnXDgMQ0nrDUJNUHPk48Bdp4YyK5V_JlByVRu2JewEI7CFDWs2kUXImyUnofR6r4efXWRhdTzAJuPRlDsgy733jtfwaB-dGa2mq6XyXyRLfNVvlyms4VB6SrWu0jSbJbPF8vVmrZFyTcYBvOfIg3nSIzv6_pIyhEn7ajtYbQ6z9b5erHM1ur4nS9gjymbp0T-_Y-LdKF86W6E3Lvgos401GnmWgyTk5PT89PJyaf8-cuP-eWbF6_Ozs7-Ag'

/** 2 × 2 computed heights, likewise. */
const COMPUTED_LINK =
  'AVVSvW7UQBAWSNR5heir9w77zve3DVdCDV0UnSb2xLeSvbZm10dOJ0tpU_ECUFPSIoREQc0TRFCkoECip0RjEunoZjSz8_3tzfsfvx5_f3LAZSM1RdihcDmJ6-qnfNWyuJp9XKcwYF86z7BIxuk4gUHI2ZO4BvYAT7WOnpNcNJ2c3l2_ffn1c3F3_e7058cPMHjtiriFnRhs2ZXbOJTCoam66BoPm4xnBnWzY8XTi1oH2KVB3ohn2UhXKUTjeXQpzOgNQiSJsGeJSc4NyoaqAHt2gEo5S016bh6IXbDELQxImAbsEIV9qZwG5IJ8yQKb9ucGO966XMEOCC1zAZvqTuC88UXYtCyb2MlAejLrDSKLkPO6v2OJLqdq03kXYVODmq42oWpahl0lfW_Qkud7nm1F3issyMdR2IfINQxa4cBDGk5YexKqg54nHwPsLDGQbaP4U4OCqdiwL2AhHIUpaliViy5E2Cgd94PVXTX46iILqecBNhuMoNgFfdx573wJg-remelyvFoks_lkkS2zxSKdzg0KV7LeRZJOptlsvliu6CIv-BJ9b_5TpOEcifFdVR1JOeKkE7U9DFZnk1W2mi8mK3V873PYY8rmIZF__2OUzpUv7QfInQsu6k5NrWauTb9-dHv7Kjs5-fPpxc3vN-tnX779BQ'

/** What is read back must be the same bits, not merely near. */
function expectSame(heights: Float32Array | null, expected: Float32Array): void {
  expect(heights?.length).toBe(expected.length)
  expect(heights?.every((height, i) => Object.is(height, expected[i]))).toBe(true)
}

async function refusal(work: Promise<unknown>): Promise<LinkError> {
  const error = await work.then(
    () => null,
    (thrown: unknown) => thrown,
  )
  expect(error).toBeInstanceOf(LinkError)
  return error as LinkError
}

function read(packed: Uint8Array, count: number): Float32Array {
  return unpackNumbers(new Reader(packed), count)
}

const CASES: [string, Float32Array][] = [
  ['whole metres', Float32Array.of(1668, 1669, 1671, 1666, 0, -12)],
  ['steps of 25 m', Float32Array.of(2000, 1425, 575, 550, 2000, 25)],
  ['tenths and hundredths', Float32Array.of(12.3, 12.35, -0.05, 0, 7.5, 1e4)],
  ['with no data', Float32Array.of(Number.NaN, 5, Number.NaN, Number.NaN, 7, -9999)],
  ['no data at all', new Float32Array(6).fill(Number.NaN)],
  ['computed', Float32Array.from([0, 1, 2, 3, 4, 5], (x) => 100 * Math.sin(x))],
  ['computed, with no data', Float32Array.of(Math.PI, Number.NaN, -Math.E, 1e-30, 3e38, -0)],
  ['negative zero', Float32Array.of(-0, 0, 1, 2, 3, 4)],
  ['flat', new Float32Array(6)],
]

test.describe('heights as bytes', () => {
  for (const [what, heights] of CASES) {
    test(`${what} come back bit by bit`, () => {
      expectSame(read(packNumbers(heights), 6), heights)
    })
  }

  test('worked by hand: 10, 30, no data, 20 count in tens, +1, +2, −1', () => {
    const packed = packNumbers(Float32Array.of(10, 30, Number.NaN, 20))
    // decimals · no places · step 10 · some are missing · ..x. · 1 → 2, 2 → 4, −1 → 1
    expect([...packed]).toEqual([0, 0, 10, 1, 0b00100000, 2, 4, 1])
  })

  test('surveyed heights take little more than a byte each', () => {
    const metres = rolling(100, 100, 400).map(Math.round)
    expect(packNumbers(metres).length).toBeLessThan(1.2 * metres.length)
  })

  test('nothing is made for heights that are not there', async () => {
    for (const packed of [[0, 0, 1, 0], [1], [0, 0, 1, 1, 255], [7], [], [0, 4, 1, 0, 2]])
      expect((await refusal((async () => read(Uint8Array.from(packed), 16_000_000))())).kind).toBe(
        'link-damaged',
      )
  })
})

test.describe('terrains in links', () => {
  for (const [what, heights] of CASES) {
    test(`a terrain, ${what}, comes back unchanged`, async () => {
      const session = terrainOf(3, 2, heights)
      const opened = await decode(await encode(session))
      expectSame(opened.scenario.heights, heights)
      expect({ ...opened, scenario: null }).toEqual({ ...session, scenario: null })
      expect(opened.scenario.spec).toEqual(session.scenario.spec)
      expect(opened.scenario.cells).toEqual(session.scenario.cells)
    })
  }

  test('links of earlier versions are read', async () => {
    for (const [link, session] of [
      [
        SURVEYED_LINK,
        terrainOf(4, 3, Float32Array.of(1668, 1669.5, Number.NaN, 1666, 0, -12, 5, 7, 1, 2, 3, 4)),
      ],
      [COMPUTED_LINK, terrainOf(2, 2, Float32Array.of(Math.PI, Number.NaN, -Math.E, 1e-30))],
    ] as const)
      expect(await decode(link)).toEqual(session)
  })

  test('rules of movement by slices, a slope and 16 moves come back', async () => {
    const session = terrainOf(9, 9, rolling(9, 9, 50))
    session.scenario.spec.movement = { moves: 16, corner_rule: 'always' }
    expect((await decode(await encode(session))).scenario.spec).toEqual(session.scenario.spec)
    session.scenario.spec.terrain = {
      vertical_unit: 0.3048,
      slices: {
        level: 12.5,
        levels: 21,
        max_aside: 2,
        max_climb: 3,
        start_level: 4,
        goal_level: 5,
        measure: 'length',
      },
    }
    expect((await decode(await encode(session))).scenario.spec).toEqual(session.scenario.spec)
  })

  test('a generated terrain is its generator call, walls drawn on it are edits', async () => {
    const session = terrainOf(257, 257, rolling(257, 257, 400))
    session.scenario.cells = (
      await generate({ generator: 'hills', seed: 1, density: 0.5 }, 257, 257)
    ).cells
    session.scenario.origin = { generator: 'hills', seed: 1, density: 0.5 }
    for (let i = 0; i < 40; i++) session.scenario.cells[700 + i] = 1
    const text = await seal((await packEdits(session, '0.1.0', generate)) ?? new Uint8Array())
    expect(text.length).toBeLessThan(1000)
    const opened = await decode(text)
    expectSame(opened.scenario.heights, session.scenario.heights ?? new Float32Array())
    expect(opened.scenario.cells).toEqual(session.scenario.cells)
    expect(opened.scenario.origin).toEqual(session.scenario.origin)
  })

  test('a terrain that its generator does not make any more carries its heights', async () => {
    const session = terrainOf(20, 20, rolling(20, 20, 300))
    session.scenario.origin = { generator: 'hills', seed: 1, density: 0.5 }
    expect(await packEdits(session, '0.1.0', generate)).toBeNull()
  })

  test('cells without data are blocked, whatever the link says', async () => {
    const session = terrainOf(2, 2, Float32Array.of(1, Number.NaN, 2, 3))
    session.scenario.cells.fill(0)
    expect([...(await decode(await encode(session))).scenario.cells]).toEqual([0, 1, 0, 0])
  })

  test('every truncation and change of a terrain’s bytes is damage', async () => {
    const bytes = packBits(terrainOf(6, 5, rolling(6, 5, 100)), '0.1.0')
    for (let at = 0; at < bytes.length; at += 3) {
      const changed = bytes.slice()
      changed[at] = (changed[at] ?? 0) ^ 4
      // Too few for the checksum itself are damaged; with it, anything that is not the same has been changed.
      const kind = at < 4 ? 'link-damaged' : 'link-changed'
      expect((await refusal(unpack(changed, generate))).kind).toBe('link-changed')
      expect((await refusal(unpack(bytes.slice(0, at), generate))).kind).toBe(kind)
    }
  })

  test('cut short behind a checksum that agrees, it is damaged all the same', async () => {
    for (const heights of [rolling(6, 5, 100), rolling(6, 5, 100).map(Math.round)]) {
      const covered = packBits(terrainOf(6, 5, heights), '0.1.0').subarray(4)
      for (let length = covered.length - 30; length < covered.length; length++) {
        const cut = withChecksum([covered.subarray(0, length)])
        expect((await refusal(unpack(cut, generate))).kind).toBe('link-damaged')
      }
    }
  })

  test('terrain without heights, and heights without terrain, are refused by name', async () => {
    const terrain = packBits(terrainOf(4, 4, rolling(4, 4, 10)), '0.1.0').subarray(4)
    const plane = withChecksum([[1], terrain.subarray(1)])
    expect(await refusal(unpack(plane, generate))).toMatchObject({
      kind: 'link-invalid',
      field: 'scenario.terrain',
    })
  })

  test('more heights than a link carries go into a file', async () => {
    const session = terrainOf(1025, 1024, new Float32Array(1025 * 1024))
    const error = await refusal((async () => packBits(session, '0.1.0'))())
    expect([error.kind, error.field]).toEqual(['link-too-large', 'heights'])
  })

  test('wrong rules are refused by name', async () => {
    // biome-ignore lint/suspicious/noExplicitAny: a document that is to be spoilt has no type
    type Document = any
    const spoilt = (change: (document: Document) => void) => {
      const session = terrainOf(8, 4, rolling(8, 4, 10))
      session.scenario.spec.terrain = {
        vertical_unit: 1,
        slices: {
          level: 1,
          levels: 20,
          max_aside: 2,
          max_climb: 2,
          start_level: 10,
          goal_level: 10,
          measure: 'cost',
        },
      }
      const copy = structuredClone(session)
      change(copy.scenario.spec.terrain)
      return packBits(copy, '0.1.0')
    }
    const cases: [string, (terrain: Document) => void][] = [
      ['vertical_unit', (d) => (d.vertical_unit = 0)],
      ['max_slope', (d) => (d.max_slope = 91)],
      ['slices', (d) => (d.slices = 4)],
      ['slices.level', (d) => (d.slices.level = -1)],
      ['slices.levels', (d) => (d.slices.levels = 256)],
      ['slices.max_aside', (d) => (d.slices.max_aside = 6)],
      ['slices.max_climb', (d) => (d.slices.max_climb = 0.5)],
      ['slices.start_level', (d) => (d.slices.start_level = 21)],
      ['slices.goal_level', (d) => (d.slices.goal_level = 0)],
      ['slices.measure', (d) => (d.slices.measure = 'time')],
    ]
    for (const [field, change] of cases) {
      const error = await refusal(unpack(spoilt(change), generate))
      expect([error.kind, error.field]).toEqual(['link-invalid', `scenario.terrain.${field}`])
    }
  })

  test('bytes are joined in order', () => {
    expect([...joined([[1], Uint8Array.of(2, 3), []])]).toEqual([1, 2, 3])
  })
})

test('the textbook’s terrain makes a short link, a survey of 144 × 144 does not', async () => {
  test.skip(!DATA, 'FORMICARIUM_DATA is not set')
  const table = readFileSync(join(DATA ?? '', 'papers/HeightData_21x21.csv'), 'utf8')
  const heights = Float32Array.from(table.trim().split(/[\s,]+/), Number)
  const short = await encode(terrainOf(21, 21, heights))
  const survey = readFileSync(join(DATA ?? '', 'dem/srtmgl3_144x144.asc'), 'utf8')
  const rows = survey.trim().split(/\r?\n/).slice(6).join(' ')
  const large = terrainOf(144, 144, Float32Array.from(rows.trim().split(/\s+/), Number))
  const long = await encode(large)
  console.log(`links: 21 × 21 ${short.length} characters, 144 × 144 ${long.length}`)
  expectSame((await decode(short)).scenario.heights, heights)
  expect(short.length).toBeLessThan(2000)
  expect(long.length).toBeGreaterThan(8000)
})
