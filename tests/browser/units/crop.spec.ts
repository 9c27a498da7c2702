/** A map cropped to what it knows: the box, its cells, its place in the world and its ends. */
import type { Imported } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import { boxOfKnown, croppedTo } from '../../../www/src/model/crop'
import { placeOf } from '../../../www/src/model/world'

const WIDTH = 6
/** `.` free, `@` a wall, `?` unknown. */
const ROWS = ['??????', '??..??', '??.@.?', '??????', '??????']
const cellsWith = (unknown: number) =>
  Uint8Array.from([...ROWS.join('')].map((c) => (c === '?' ? unknown : Number(c === '@'))))

function imported(cells: Uint8Array): Imported {
  const factors = new Float32Array(cells.length).map((_, i) => 1 + i)
  const goal = { name: 'dock', area: 1, strength: 1, danger: 1 }
  return {
    kind: 'ros-map',
    spec: {
      name: 'small',
      width: WIDTH,
      height: ROWS.length,
      resolution: 0.5,
      movement: { moves: 8, corner_rule: 'both-free' },
      start: [2, 1],
      goals: [{ ...goal, at: [4, 2] }],
      vehicle: { speed: 1, seconds_per_turn: 0 },
      world: { x: -1, y: 2, yaw: 0.3, frame: 'map' },
    },
    cells,
    heights: new Uint8Array(),
    factors: new Uint8Array(factors.buffer),
    warnings: [
      {
        kind: 'ends-chosen',
        message: 'no start and goal is read from the file: start (2, 1) and goal (4, 2) are used',
        args: { start: '2,1', goal: '4,2' },
      },
    ],
  }
}

const boxOf = (one: Uint8Array, other: Uint8Array) => boxOfKnown(one, other, WIDTH)

test('the box holds what is known and a ring of what is not, whatever that counts as', () => {
  const box = { x: 1, y: 0, width: 5, height: 4 }
  expect(boxOf(cellsWith(1), cellsWith(0))).toEqual(box)
  expect(boxOf(cellsWith(0), cellsWith(1))).toEqual(box)
  expect(boxOf(new Uint8Array(30), new Uint8Array(30).fill(1))).toBeNull()
  expect(boxOf(cellsWith(1), cellsWith(1))).toEqual({ x: 0, y: 0, width: 6, height: 5 })
})

test('cells, factors and ends move together, and stay where they are in the world', () => {
  const whole = imported(cellsWith(1))
  const map = croppedTo(whole, { x: 1, y: 0, width: 5, height: 4 })
  expect([map.spec.width, map.spec.height, map.cells.length]).toEqual([5, 4, 20])
  expect([map.spec.start, map.spec.goals[0]?.at]).toEqual([
    [1, 1],
    [3, 2],
  ])
  expect(map.cells[2 * 5 + 2]).toBe(1)
  expect(map.cells[2 * 5 + 3]).toBe(0)
  expect(new Float32Array(map.factors.slice().buffer)[6]).toBe(1 + 8)
  for (const [before, after] of [
    [whole.spec.start, map.spec.start],
    [
      [4, 2],
      [3, 2],
    ],
  ] as [[number, number], [number, number]][]) {
    const [x = 0, y = 0] = placeOf(whole.spec, before) ?? []
    expect(placeOf(map.spec, after)?.[0]).toBeCloseTo(x, 12)
    expect(placeOf(map.spec, after)?.[1]).toBeCloseTo(y, 12)
  }
  expect(map.warnings[0]).toMatchObject({
    message: 'no start and goal is read from the file: start (1, 1) and goal (3, 2) are used',
    args: { start: '1,1', goal: '3,2' },
  })
})

test('ends beside the box move to free cells in it', () => {
  const free = imported(cellsWith(0))
  free.spec.start = [0, 4]
  const { spec, cells } = croppedTo(free, { x: 1, y: 0, width: 5, height: 4 })
  expect(spec.start).toEqual([0, 3])
  expect(cells[3 * 5]).toBe(0)
})
