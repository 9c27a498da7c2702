/** Where legends stand: clear of markers, and of cells where that can be. */
import { expect, test } from '@playwright/test'
import type { Cell } from '../../../www/src/model/cell'
import { type LegendPlace, legendPlace } from '../../../www/src/model/legend_place'
import { sessionOf } from './sessions'

const SIZES = {
  full: { width: 184, height: 40 },
  line: { width: 264, height: 20 },
  bar: { width: 144, height: 20 },
}
const [WIDTH, HEIGHT] = [40, 20]

/** On a stage as large as its map, with cells of 20. */
function placed(ends: Cell[], walls: Cell[] = [], before: LegendPlace | null = null, room = 0) {
  const cells = new Uint8Array(WIDTH * HEIGHT)
  for (const [x, y] of walls) cells[y * WIDTH + x] = 1
  const { scenario } = sessionOf(WIDTH, HEIGHT, cells)
  const [start, ...goals] = ends
  const spec = {
    ...scenario.spec,
    start: start ?? scenario.spec.start,
    goals: goals.map((at) => ({ ...scenario.spec.goals[0], at, name: '' })),
  }
  const stage = { width: 20 * WIDTH, height: 20 * HEIGHT + 2 * room }
  const map = { left: 0, top: room, cell: 20 }
  return legendPlace(stage, map, { ...scenario, spec } as typeof scenario, SIZES, before)
}

const AWAY: Cell[] = [
  [20, 10],
  [22, 10],
]
const corner = (x: number, y: number, width: number, height: number): Cell[] =>
  Array.from({ length: width * height }, (_, i) => [x + (i % width), y + Math.floor(i / width)])

test('beside the map and over walls a legend has all it says, over free cells one line', () => {
  expect(placed(AWAY)).toEqual({ shape: 'line', side: 'right-bottom' })
  expect(placed(AWAY, [], null, 60)).toEqual({ shape: 'full', side: 'right-bottom' })
  // Less room than a title takes.
  expect(placed(AWAY, [], null, 28)).toEqual({ shape: 'line', side: 'right-bottom' })
  expect(placed(AWAY, corner(0, 0, 12, 4))).toEqual({ shape: 'full', side: 'left-top' })
})

test('it never covers a marker, and is left out where every corner has one', () => {
  const ends: Cell[] = [
    [39, 19],
    [0, 19],
    [39, 0],
    [0, 0],
  ]
  const seen = (all: Cell[]) => placed([...AWAY, ...all])?.side
  expect(seen(ends.slice(0, 1))).toBe('left-bottom')
  expect(seen(ends.slice(0, 2))).toBe('right-top')
  expect(seen(ends.slice(0, 3))).toBe('left-top')
  expect(placed([...AWAY, ...ends])).toBeNull()
  // A marker reaches beyond its cell.
  expect(seen([[35, 18]])).toBe('left-bottom')
})

test('it stays where it is while nothing better is far better', () => {
  const before: LegendPlace = { shape: 'line', side: 'left-top' }
  expect(placed(AWAY, corner(27, 18, 2, 2), before)).toEqual(before)
  expect(placed(AWAY, corner(27, 18, 11, 2), before)?.side).toBe('right-bottom')
  expect(placed([[0, 0], ...AWAY], [], before)?.side).toBe('right-bottom')
})

test('on a narrow stage it is no wider than that', () => {
  const { scenario } = sessionOf(WIDTH, HEIGHT, new Uint8Array(WIDTH * HEIGHT))
  const on = (width: number) =>
    legendPlace(
      { width, height: 300 },
      { left: 10, top: 80, cell: 6 },
      { ...scenario, spec: { ...scenario.spec, start: [20, 10] } },
      SIZES,
      null,
    )
  expect(on(262)).toEqual({ shape: 'full', side: 'right-bottom' })
  expect(on(190)?.shape).toBe('bar')
  expect(on(140)).toBeNull()
})
