import { expect, test } from '@playwright/test'
import { blockOf, freeBlock, layBlock, turnBlock } from '../../../www/src/model/block'
import { applyEditTo } from '../../../www/src/model/edit'
import { resized } from '../../../www/src/model/resize'
import { endsWithRoom, fittingRadius, withoutRoom } from '../../../www/src/model/robot_room'
import type { Scenario, Session } from '../../../www/src/model/session'
import { groundsOf } from '../../../www/src/model/terrain'
import { TURNS, turnMap } from '../../../www/src/model/turn'
import { factorAt, mostFactor, strengthOf, weighed } from '../../../www/src/model/weights'
import { packBits, packEdits, unpack, withChecksum } from '../../../www/src/share/codec'
import { open, seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'
import { documentOf, readDocument } from '../../../www/src/share/session_document'
import { generate, sessionOf, terrainOf } from './sessions'

const blank = (): Scenario => sessionOf(6, 4, new Uint8Array(24)).scenario
const link = async (session: Session) =>
  unpack(await open(await seal(packBits(session, '0.1.0'))), generate)

function weightedSession(factors: ArrayLike<number>, width = 3): Session {
  const height = factors.length / width
  const session = sessionOf(width, height, new Uint8Array(factors.length))
  return { ...session, scenario: { ...session.scenario, factors: Float32Array.from(factors) } }
}

async function refusal(read: () => unknown): Promise<string> {
  try {
    await read()
    return 'none'
  } catch (thrown) {
    return thrown instanceof LinkError ? `${thrown.kind} ${thrown.field}` : String(thrown)
  }
}

test.describe('ground that costs more', () => {
  test('all factors 1 are none, and what changes nothing is the same map', () => {
    const map = blank()
    const dear = weighed(map, [7, 8], 2.5)
    expect([factorAt(dear, [1, 1]), factorAt(dear, [2, 1]), factorAt(dear, [3, 1])]).toEqual([
      2.5, 2.5, 1,
    ])
    expect(dear.cells).not.toBe(map.cells)
    expect(map.factors).toBeNull()
    expect(weighed(dear, [7], 2.5)).toBe(dear)
    expect(weighed(map, [7], 1)).toBe(map)
    expect(weighed(dear, [7, 8], 1).factors).toBeNull()
  })

  test('walls stay walls, and terrains have no factors', () => {
    const walled = applyEditTo(blank(), { kind: 'cells', cells: [7], blocked: true })
    expect(weighed(walled, [7], 3)).toBe(walled)
    const terrain = terrainOf(3, 2, new Float32Array(6)).scenario
    expect(weighed(terrain, [2], 3)).toBe(terrain)
    const [under, beside] = [weighed(blank(), [7], 9), weighed(walled, [8], 4)]
    expect([mostFactor(under), mostFactor(beside), mostFactor(blank())]).toEqual([9, 4, 1])
    const covered = applyEditTo(under, { kind: 'cells', cells: [7], blocked: true })
    expect(mostFactor(covered)).toBe(1)
  })

  test('tints grow with the logarithm, up to ten', () => {
    expect([1, 10, 1000].map(strengthOf)).toEqual([0, 1, 1])
    expect(strengthOf(Math.sqrt(10))).toBeCloseTo(0.5, 12)
  })

  test('a part takes its ground along, and uncovers what was there', () => {
    const map = weighed(weighed(blank(), [7], 3), [10], 5)
    const area = { x: 1, y: 1, width: 2, height: 1 }
    const base = layBlock(map, freeBlock(area), [1, 1]).map
    expect(factorAt(base, [1, 1])).toBe(1)
    const laid = layBlock(base, blockOf(map, area), [3, 1]).map
    expect([factorAt(laid, [3, 1]), factorAt(laid, [4, 1])]).toEqual([3, 1])
    expect(factorAt(layBlock(base, blockOf(map, area), [3, 2]).map, [4, 1])).toBe(5)
    expect(layBlock(map, blockOf(map, area), [1, 1]).map).toBe(map)
  })

  for (const turn of TURNS)
    test(`turned: ${turn}`, () => {
      const map = weighed(blank(), [8], 4)
      const area = { x: 0, y: 0, width: 6, height: 4 }
      const turned = turnMap(map, turn)
      expect(turned.factors).toEqual(turnBlock(blockOf(map, area), turn).factors)
      const was = (factors: Float32Array | null) => [...(factors ?? [])].filter((f) => f === 4)
      expect(was(turned.factors)).toEqual([4])
    })

  test('a larger map has plain ground around, a smaller one may have plain ground alone', () => {
    const map = weighed(blank(), [1, 23], 2)
    const larger = resized(map, 7, 5)
    expect([factorAt(larger, [1, 0]), factorAt(larger, [5, 3]), factorAt(larger, [6, 4])]).toEqual([
      2, 2, 1,
    ])
    expect(resized(map, 5, 3).factors?.[1]).toBe(2)
    expect(resized(weighed(blank(), [23], 2), 5, 3).factors).toBeNull()
  })

  test('planners must know it on top of how one moves', () => {
    const map = blank()
    expect(groundsOf(map)).toEqual(['plane'])
    expect(groundsOf(weighed(map, [7], 2))).toEqual(['plane', 'weighted'])
    const spec = { ...map.spec, robot: { radius: 0.5 } }
    expect(groundsOf({ ...map, spec })).toEqual(['plane'])
    const inflation = { radius: 1, cost_scaling: 10, rule: 'nav2-navfn' as const, multiplier: 2 }
    expect(groundsOf({ ...map, spec: { ...spec, robot: { radius: 0, inflation } } })).toEqual([
      'plane',
      'weighted',
    ])
  })
})

test.describe('shared', () => {
  const cases: [string, number[]][] = [
    ['chosen', [1, 1.5, 2, 3, 5, 10]],
    ['computed', [1, Math.PI, 1 + 2 ** -20, 999.99, 1.1, 1000].map(Math.fround)],
  ]
  for (const [what, factors] of cases)
    test(`a link brings factors back, ${what}`, async () => {
      const session = weightedSession(factors)
      expect(await link(session)).toEqual(session)
      expect(packBits(session, '')[4]).toBe(3)
    })

  test('a robot and its inflation come back, and what they ask is version 3 of the document', async () => {
    const session = sessionOf(4, 3)
    const rule = 'nav2-smac-2d'
    session.scenario.spec.robot = {
      radius: 0.22,
      inflation: { radius: 0.7, cost_scaling: 5, rule, multiplier: 3 },
    }
    expect(await link(session)).toEqual(session)
    expect(packBits(session, '')[4]).toBe(1)
    expect(documentOf(session, '').format).toBe('formicarium/experiment@3')
    expect(documentOf(weightedSession([1, 2, 1]), '').format).toBe('formicarium/experiment@3')
    expect(documentOf(sessionOf(4, 3), '').format).toBe('formicarium/experiment@1')
  })

  test('no generator makes factors, so that they travel themselves', async () => {
    const session = weightedSession([1, 2, 1])
    session.scenario.origin = { generator: 'random', seed: 1, density: 0.2 }
    expect(await packEdits(session, '', generate)).toBeNull()
  })

  test('what the engine would refuse is refused by name', async () => {
    for (const wrong of [0.5, Number.NaN, 1001])
      expect(await refusal(() => link(weightedSession([1, wrong, 2])))).toBe('link-invalid factors')
    const session = weightedSession([1, 2, 3])
    const older = { ...documentOf(session, ''), format: 'formicarium/experiment@1' }
    const robot = { ...session.scenario.spec, robot: { radius: 1 } }
    expect(await refusal(() => readDocument({ ...older, scenario: robot }))).toBe(
      'link-invalid scenario.robot',
    )
    const newer = packBits(session, '').slice(4)
    newer[0] = 4
    expect(await refusal(async () => unpack(withChecksum([newer]), generate))).toContain(
      'link-newer',
    )
  })
})

test.describe('room for a robot', () => {
  // A corridor of one cell that opens into a hall of three.
  const map = (): Scenario => {
    const rows = ['#######', '###...#', '......#', '###...#', '#######']
    const cells = Uint8Array.from(rows.join(''), (char) => (char === '#' ? 1 : 0))
    const { scenario } = sessionOf(7, 5, cells)
    const goals = scenario.spec.goals.map((goal) => ({ ...goal, at: [4, 2] as [number, number] }))
    return { ...scenario, spec: { ...scenario.spec, resolution: 0.5, start: [1, 2], goals } }
  }
  /** With a radius of one cell: whatever touches a wall is too narrow. */
  const felt = {
    blocked: Uint8Array.from({ length: 35 }, (_, cell) => (cell === 18 ? 0 : 1)),
    factors: null,
  }

  test('who does not fit is told, the start first', () => {
    const { spec } = map()
    expect(withoutRoom(spec, felt)).toBe('start')
    expect(withoutRoom({ ...spec, start: [4, 2] }, felt)).toBeNull()
    expect(
      withoutRoom(
        {
          ...spec,
          start: [4, 2],
          goals: map().spec.goals.map((goal) => ({ ...goal, at: [1, 2] })),
        },
        felt,
      ),
    ).toBe('goal')
  })

  test('ends move to the nearest cells with room, each to one of its own', () => {
    const blocked = felt.blocked.slice()
    blocked[19] = 0
    const ends = endsWithRoom(map().spec, { blocked, factors: null })
    expect(ends?.start).toEqual([4, 2])
    expect(ends?.goals[0]?.at).toEqual([5, 2])
    expect(endsWithRoom(map().spec, { blocked: blocked.fill(1), factors: null })).toBeNull()
  })

  test('the largest radius that fits is less than the way to the nearest wall', () => {
    // The start has walls one cell away, half a metre.
    expect(fittingRadius(map())).toBe(0.499)
    const { spec } = map()
    expect(fittingRadius({ ...map(), spec: { ...spec, start: [5, 2], goals: spec.goals } })).toBe(
      0.499,
    )
  })
})
