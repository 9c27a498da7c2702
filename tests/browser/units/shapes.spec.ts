import { expect, test } from '@playwright/test'
import { blockOf, freeBlock, layBlock, turnBlock } from '../../../www/src/model/block'
import type { Cell } from '../../../www/src/model/cell'
import { applyEditTo, refusalOf } from '../../../www/src/model/edit'
import type { Scenario } from '../../../www/src/model/session'
import {
  areaBetween,
  areaSpans,
  borderSpans,
  floodSpans,
  lineSpans,
  numbersOf,
  type Span,
  squareAbout,
  squared,
  straightened,
} from '../../../www/src/model/spans'
import { placeAfter, TURNS, turnMap, turnRefused } from '../../../www/src/model/turn'
import { placeOf } from '../../../www/src/model/world'
import { rolling, sessionOf, terrainOf } from './sessions'

const map = { width: 10, height: 6 }
const blank = () => sessionOf(10, 6, new Uint8Array(60)).scenario

/** The map as rows of text, `#` where there is a wall. */
function rows({ spec, cells }: Scenario): string[] {
  return Array.from({ length: spec.height }, (_, y) =>
    Array.from(cells.subarray(y * spec.width, (y + 1) * spec.width), (c) => '.#'[c]).join(''),
  )
}

function drawn(text: string[]): Scenario {
  const width = text[0]?.length ?? 0
  const cells = Uint8Array.from(text.join(''), (char) => (char === '#' ? 1 : 0))
  return sessionOf(width, text.length, cells).scenario
}

const painted = (spans: Span[], scenario = blank(), blocked = true) =>
  applyEditTo(scenario, { kind: 'cells', cells: numbersOf(spans, scenario.spec), blocked })

test.describe('shapes', () => {
  test('a brush of any size is a square about its cell, as far as the map goes', () => {
    for (const side of [1, 2, 3, 5, 9]) {
      const cells = new Set(
        numbersOf(squareAbout([20, 20], side, { width: 50, height: 50 }), {
          width: 50,
          height: 50,
        }),
      )
      expect(cells.size).toBe(side * side)
      expect(cells.has(20 * 50 + 20)).toBe(true)
    }
    expect(numbersOf(squareAbout([0, 0], 3, map), map)).toEqual(Uint32Array.from([0, 1, 10, 11]))
    expect(squareAbout([-5, -5], 3, map)).toEqual([])
  })

  test('a wide line covers the way of its brush', () => {
    expect(rows(painted(lineSpans([2, 1], [5, 4], 2, map)))).toEqual([
      '..........',
      '..##......',
      '..###.....',
      '...###....',
      '....###...',
      '.....##...',
    ])
  })

  test('a rectangle is its border, a filled one all of it, from any corner', () => {
    for (const [a, b] of [
      [
        [2, 1],
        [6, 4],
      ],
      [
        [6, 4],
        [2, 1],
      ],
      [
        [2, 4],
        [6, 1],
      ],
    ] as [Cell, Cell][]) {
      expect(rows(painted(borderSpans(a, b, 1, map)))).toEqual([
        '..........',
        '..#####...',
        '..#...#...',
        '..#...#...',
        '..#####...',
        '..........',
      ])
      expect(areaBetween(a, b)).toEqual({ x: 2, y: 1, width: 5, height: 4 })
      expect(numbersOf(areaSpans(areaBetween(a, b), map), map)).toHaveLength(20)
    }
  })

  test('with Shift lines go in eight directions, and rectangles are squares', () => {
    const straight: [Cell, Cell][] = [
      [
        [5, 1],
        [5, 0],
      ],
      [
        [1, 6],
        [0, 6],
      ],
      [
        [5, 4],
        [5, 5],
      ],
      [
        [-4, 6],
        [-6, 6],
      ],
      [
        [-7, -1],
        [-7, 0],
      ],
    ]
    for (const [to, guided] of straight) expect(straightened([0, 0], to)).toEqual(guided)
    expect(squared([3, 3], [1, 8])).toEqual([-2, 8])
  })

  test('fill covers what straight steps reach, and no more', () => {
    const scenario = drawn([
      '....#.....',
      '....#.....',
      '.##.#..##.',
      '.#.##..##.',
      '.#.#......',
      '.###......',
    ])
    const left = painted(floodSpans(scenario, [1, 0]), scenario)
    // The start stays free; the pocket touches by corners alone.
    expect(rows(left)).toEqual([
      '.####.....',
      '#####.....',
      '#####..##.',
      '##.##..##.',
      '##.#......',
      '####......',
    ])
    const torn = painted(floodSpans(scenario, [7, 2]), scenario, false)
    expect(rows(torn)[2]).toBe('.##.#.....')
    expect(torn.cells.reduce((sum, cell) => sum + cell, 0)).toBe(
      scenario.cells.reduce((sum, cell) => sum + cell, 0) - 4,
    )
    expect(floodSpans(scenario, [99, 0])).toEqual([])
  })

  test('every cell of a fill is found once, on maps that wind', () => {
    const noise = sessionOf(61, 47).scenario
    const seen = numbersOf(floodSpans(noise, [0, 0]), noise.spec)
    expect(new Set(seen).size).toBe(seen.length)
    const reached = new Set(seen)
    const wrong: Cell[] = []
    for (const cell of seen) {
      const [x, y] = [cell % 61, Math.floor(cell / 61)]
      const beside: Cell[] = [
        [x + 1, y],
        [x - 1, y],
        [x, y + 1],
        [x, y - 1],
      ]
      for (const [nx, ny] of beside) {
        const next = ny * 61 + nx
        const alike = noise.cells[next] === noise.cells[0]
        if (nx < 0 || ny < 0 || nx >= 61 || ny >= 47 || reached.has(next) === alike) continue
        wrong.push([nx, ny])
      }
    }
    expect(wrong).toEqual([])
  })

  test('where there is no data nothing is freed, and that is said', () => {
    const heights = rolling(4, 3, 50)
    heights[5] = Number.NaN
    const scenario = terrainOf(4, 3, heights).scenario
    const edit = { kind: 'cells', cells: Uint32Array.from([5]), blocked: false } as const
    expect(applyEditTo(scenario, edit)).toBe(scenario)
    expect(refusalOf(scenario, edit)).toBe('erase')
    expect(refusalOf(scenario, { ...edit, blocked: true })).toBeNull()
  })
})

test.describe('parts of a map', () => {
  const scenario = drawn(['......', '.##...', '.#....', '......'])
  const area = { x: 1, y: 1, width: 2, height: 2 }

  test('a part that is moved covers what was there, and uncovers what it leaves', () => {
    const base = layBlock(scenario, freeBlock(area), [1, 1]).map
    const laid = layBlock(base, blockOf(scenario, area), [3, 1])
    expect(rows(laid.map)).toEqual(['......', '...##.', '...#..', '......'])
    expect(laid.keptFree).toBe(0)
    expect(rows(scenario)[1]).toBe('.##...')
  })

  test('start and goals stay free, and the outside is left alone', () => {
    const block = { width: 2, height: 2, cells: Uint8Array.from([1, 1, 1, 1]), factors: null }
    const laid = layBlock(scenario, block, [0, 0])
    expect(laid.keptFree).toBe(1)
    expect(rows(laid.map)[0]).toBe('.#....')
    expect(rows(layBlock(scenario, block, [-1, -1]).map)).toEqual(rows(scenario))
    expect(layBlock(scenario, freeBlock({ width: 1, height: 1 }), [0, 0]).map).toBe(scenario)
  })

  test('what has no data is neither taken up nor covered', () => {
    const heights = rolling(4, 3, 50)
    heights[5] = Number.NaN
    const terrain = terrainOf(4, 3, heights).scenario
    expect(blockOf(terrain, { x: 1, y: 1, width: 1, height: 1 }).cells).toEqual(Uint8Array.of(2))
    expect(layBlock(terrain, freeBlock({ width: 4, height: 3 }), [0, 0]).map).toBe(terrain)
  })

  test('four quarters, and mirroring twice, give it back', () => {
    const block = blockOf(scenario, { x: 0, y: 0, width: 6, height: 4 })
    for (const [turn, times] of [
      ['left', 4],
      ['right', 4],
      ['mirror', 2],
      ['flip', 2],
    ] as const) {
      let turned = block
      for (let i = 0; i < times; i++) turned = turnBlock(turned, turn)
      expect(turned, turn).toEqual(block)
    }
    const once = turnBlock(blockOf(scenario, area), 'right')
    expect([...once.cells]).toEqual([1, 1, 0, 1])
  })
})

test.describe('the whole map', () => {
  test('start, goals and heights go with their cells; the origin is dropped', () => {
    const terrain = terrainOf(5, 3, rolling(5, 3, 70)).scenario
    terrain.cells[6] = 1
    terrain.origin = { generator: 'hills', seed: 1, density: 0.5 }
    for (const turn of TURNS) {
      const turned = turnMap(terrain, turn)
      const { width } = turned.spec
      expect(turned.origin).toBeNull()
      for (let y = 0; y < 3; y++)
        for (let x = 0; x < 5; x++) {
          const [tx, ty] = placeAfter([x, y], terrain.spec, turn)
          expect(turned.cells[ty * width + tx]).toBe(terrain.cells[y * 5 + x])
          expect(turned.heights?.[ty * width + tx]).toBe(terrain.heights?.[y * 5 + x])
        }
      expect(turned.spec.start).toEqual(placeAfter(terrain.spec.start, terrain.spec, turn))
      expect(turned.spec.goals[0]?.at).toEqual(
        placeAfter(terrain.spec.goals[0]?.at ?? [0, 0], terrain.spec, turn),
      )
    }
    expect(turnMap(terrain, 'left').spec).toMatchObject({ width: 3, height: 5 })
  })

  test('turned, every cell keeps its place in the world; mirrored, the map has none', () => {
    const before = blank()
    before.spec.world = { x: 12, y: -7, yaw: 0.4, frame: 'map' }
    for (const turn of ['left', 'right'] as const) {
      const turned = turnMap(before, turn)
      for (const cell of [
        [0, 0],
        [9, 0],
        [3, 5],
      ] as Cell[]) {
        const [x, y] = placeOf(before.spec, cell) ?? [0, 0]
        const [tx, ty] = placeOf(turned.spec, placeAfter(cell, before.spec, turn)) ?? [1, 1]
        expect(tx).toBeCloseTo(x, 9)
        expect(ty).toBeCloseTo(y, 9)
      }
      expect(turned.spec.world?.frame).toBe('map')
    }
    expect(turnMap(before, 'mirror').spec.world).toBeUndefined()
    expect(turnMap(before, 'flip').spec.world).toBeUndefined()
  })

  test('by slices a map is mirrored, never turned', () => {
    const terrain = terrainOf(5, 3, rolling(5, 3, 70)).scenario
    expect(TURNS.filter((turn) => turnRefused(terrain, turn))).toEqual([])
    const slices = {
      level: 10,
      levels: 20,
      max_aside: 2,
      max_climb: 2,
      start_level: 1,
      goal_level: 1,
    }
    terrain.spec.terrain = { vertical_unit: 1, slices: { ...slices, measure: 'cost' } }
    expect(TURNS.filter((turn) => turnRefused(terrain, turn))).toEqual(['left', 'right'])
  })
})
