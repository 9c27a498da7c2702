/** Which maps have a scale, how metres are rounded, and where scale bars stand. */
import { expect, test } from '@playwright/test'
import type { Cell } from '../../../www/src/model/cell'
import { barSide, type LegendSide } from '../../../www/src/model/legend_place'
import { decimalsFor, roundLength } from '../../../www/src/model/metres'
import { fromCorner, scaleOf } from '../../../www/src/model/world'
import { sessionOf } from './sessions'

const WORLD = { x: 0, y: 0, yaw: 0, frame: '' }

test('a map has a scale on a terrain, in the world, or where a cell is not one metre', () => {
  const { spec } = sessionOf(4, 3, new Uint8Array(12)).scenario
  expect(scaleOf({ ...spec, resolution: 1 })).toBeNull()
  expect(scaleOf({ ...spec, resolution: 0.05 })).toBe(0.05)
  expect(scaleOf({ ...spec, resolution: 1, world: WORLD })).toBe(1)
  expect(scaleOf({ ...spec, resolution: 1, terrain: { vertical_unit: 1 } })).toBe(1)
  expect(fromCorner({ ...spec, resolution: 0.5 }, [1, 2])).toEqual([0.75, 0.25])
})

test('a scale bar has the longest round length that it has room for', () => {
  for (const [perPixel, length] of [
    [0.05, 2],
    [0.0625, 5],
    [0.0124, 0.5],
    [0.003, 0.2],
    [0.00125, 0.1],
    [1, 50],
    [12.5, 1000],
    [13, 1000],
    [1e-5, 5e-4],
  ] as const)
    expect([perPixel, roundLength(perPixel, 80)]).toEqual([perPixel, length])
})

test('metres tell centimetres at least, and cells apart', () => {
  expect([30, 1, 0.05, 0.01, 0.005, 0.001, 1e-9].map(decimalsFor)).toEqual([2, 2, 2, 2, 3, 3, 6])
})

/** On a stage of 400 × 300 as large as its map, with cells of 20. */
function placed(
  ends: Cell[],
  legend: { side: LegendSide; size: { width: number; height: number } } | null = null,
  before: LegendSide | null = null,
) {
  const { scenario } = sessionOf(20, 15, new Uint8Array(300))
  const [start = scenario.spec.start, ...goals] = ends
  const spec = {
    ...scenario.spec,
    start,
    goals: goals.map((at) => ({ at, name: '', area: 1, strength: 1, danger: 1 })),
  }
  const map = { left: 0, top: 0, cell: 20 }
  const [stage, size] = [
    { width: 400, height: 300 },
    { width: 152, height: 20 },
  ]
  return barSide(stage, map, { ...scenario, spec } as typeof scenario, size, legend, before)
}

const AWAY: Cell[] = [
  [9, 7],
  [11, 7],
]

test('a scale bar stands at the lower left, or where neither marker nor legend is', () => {
  expect(placed(AWAY)).toBe('left-bottom')
  expect(placed([[0, 14], ...AWAY])).toBe('right-bottom')
  const line = { width: 264, height: 20 }
  expect(placed(AWAY, { side: 'right-bottom', size: line })).toBe('left-top')
  expect(placed(AWAY, { side: 'right-bottom', size: { width: 160, height: 20 } })).toBe(
    'left-bottom',
  )
  expect(placed(AWAY, null, 'right-top')).toBe('right-top')
  const corners: Cell[] = [
    [0, 14],
    [19, 14],
    [0, 0],
    [19, 0],
  ]
  expect(placed(corners)).toBeNull()
})
