import type { Survey } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import { applyEditTo, type Edit, refusalOf } from '../../../www/src/model/edit'
import { hillShade } from '../../../www/src/model/hill_shade'
import {
  cellOf,
  cropBetween,
  cropFits,
  sizeOf,
  suggested,
  wholeOf,
  withSide,
} from '../../../www/src/model/raster_part'
import { resized } from '../../../www/src/model/resize'
import type { Scenario } from '../../../www/src/model/session'
import {
  groundAt,
  groundOf,
  liftEnds,
  lowestLevel,
  shiftLevel,
} from '../../../www/src/model/terrain'
import { terrainOf } from './sessions'

const NO = Number.NaN

/** 4 × 3, start at (0, 0), goal at (3, 2); no data in the lower left and beside the goal. */
function ground(): Scenario {
  // biome-ignore format: as a map
  const heights = Float32Array.of(
    10, 20, 30, 40,
    15, 25, 35, 45,
    NO, 30, NO, 100,
  )
  return terrainOf(4, 3, heights).scenario
}

test.describe('edits of a terrain', () => {
  test('nothing is freed where there is no data, and that is said', () => {
    const scenario = ground()
    const edit: Edit = { kind: 'paint', from: [0, 2], to: [0, 2], blocked: false }
    expect(applyEditTo(scenario, edit)).toBe(scenario)
    expect(refusalOf(scenario, edit)).toBe('erase')
    expect(refusalOf(scenario, { ...edit, from: [1, 1], to: [1, 1] })).toBeNull()
  })

  test('start and goals cannot be put where there is no data', () => {
    const scenario = ground()
    const edits: Edit[] = [
      { kind: 'start', at: [0, 2] },
      { kind: 'goal', index: 0, at: [2, 2] },
      { kind: 'goal', index: 1, at: [2, 2] },
    ]
    for (const edit of edits) {
      expect(applyEditTo(scenario, edit)).toBe(scenario)
      expect(refusalOf(scenario, edit)).toBe('end')
    }
    expect(refusalOf(scenario, { kind: 'start', at: [3, 2] })).toBeNull()
    expect(refusalOf(scenario, { kind: 'start', at: [-1, 0] })).toBeNull()
  })

  test('clearing keeps the cells without data blocked, and the terrain’s origin', () => {
    const scenario = { ...ground(), origin: { generator: 'hills', seed: 1, density: 0.5 } as const }
    expect(applyEditTo(scenario, { kind: 'clear' })).toBe(scenario)
    const walled = applyEditTo(scenario, { kind: 'paint', from: [0, 1], to: [3, 1], blocked: true })
    const cleared = applyEditTo(walled, { kind: 'clear' })
    expect([...cleared.cells]).toEqual([0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0])
    expect(cleared.origin).toEqual(scenario.origin)
  })

  test('a larger map has no data in its new cells, a smaller one keeps its part', () => {
    const large = resized(ground(), 5, 4)
    expect([...(large.heights ?? [])]).toEqual([
      10,
      20,
      30,
      40,
      NO,
      15,
      25,
      35,
      45,
      NO,
      NO,
      30,
      NO,
      100,
      NO,
      NO,
      NO,
      NO,
      NO,
      NO,
    ])
    expect([...large.cells]).toEqual([0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1])
    const small = resized(ground(), 3, 3)
    expect([...(small.heights ?? [])]).toEqual([10, 20, 30, 15, 25, 35, NO, 30, NO])
    // The nearest cell inside, (2, 2), has no data.
    expect(small.spec.goals[0]?.at).toEqual([2, 1])
    expect([...small.cells]).toEqual([0, 0, 0, 0, 0, 0, 1, 0, 1])
  })

  test('a part without data has no place for the ends: nothing changes', () => {
    const heights = Float32Array.from({ length: 16 }, (_, i) => (i % 4 < 2 && i < 8 ? NO : i))
    const scenario = terrainOf(4, 4, heights).scenario
    expect(resized(scenario, 2, 2)).toBe(scenario)
  })
})

test.describe('movement by slices', () => {
  /** Levels of 10 m, ten of them up to the top. */
  const rules = {
    level: 10,
    levels: 20,
    max_aside: 2,
    max_climb: 2,
    start_level: 2,
    goal_level: 11,
    measure: 'cost',
  } as const
  const sliced = (): Scenario => {
    const scenario = ground()
    const terrain = { vertical_unit: 1, slices: rules }
    return { ...scenario, spec: { ...scenario.spec, terrain } }
  }
  const levels = ({ spec }: Scenario) => [
    spec.terrain?.slices?.start_level,
    spec.terrain?.slices?.goal_level,
  ]

  test('an end may lie on the ground or above it, up to the highest level', () => {
    const scenario = sliced()
    expect(lowestLevel(scenario, [0, 0], rules)).toBe(1)
    expect(lowestLevel(scenario, [3, 2], rules)).toBe(10)
    expect(lowestLevel(scenario, [1, 1], rules)).toBe(3)
    expect(levels(shiftLevel(scenario, 'start', -1))).toEqual([1, 11])
    expect(levels(shiftLevel(scenario, 'start', -5))).toEqual([1, 11])
    expect(levels(shiftLevel(scenario, 'goal', -5))).toEqual([2, 10])
    expect(levels(shiftLevel(scenario, 'goal', 50))).toEqual([2, 20])
    const lowest = shiftLevel(scenario, 'goal', -1)
    expect(shiftLevel(lowest, 'goal', -1)).toBe(lowest)
  })

  test('an end that is moved onto higher ground rises with it', () => {
    const moved = applyEditTo(sliced(), { kind: 'start', at: [3, 1] })
    expect(levels(moved)).toEqual([5, 11])
    expect(liftEnds(moved)).toBe(moved)
  })

  test('the goal that takes over from the first is lifted out of the ground', () => {
    const low = applyEditTo(sliced(), { kind: 'goal', index: 0, at: [1, 0] })
    const two = applyEditTo(shiftLevel(low, 'goal', -20), { kind: 'goal', index: 1, at: [3, 1] })
    expect(levels(two)).toEqual([2, 2])
    expect(levels(applyEditTo(two, { kind: 'remove-goal', index: 0 }))).toEqual([2, 5])
  })

  test('ground above all levels takes no end, and that is said', () => {
    const scenario = sliced()
    const { spec } = scenario
    const goal = { at: [0, 1] as [number, number], name: '', area: 1, strength: 1, danger: 1 }
    const slices = { ...rules, levels: 4, goal_level: 4 }
    const terrain = { vertical_unit: 1, slices }
    const set: Scenario = { ...scenario, spec: { ...spec, goals: [goal], terrain } }
    const edit: Edit = { kind: 'start', at: [3, 2] }
    expect(applyEditTo(set, edit)).toBe(set)
    expect(refusalOf(set, edit)).toBe('level')
  })

  test('the ways of moving that planners know', () => {
    const surface = ground()
    expect(groundOf(surface.spec)).toBe('surface')
    expect(groundOf(sliced().spec)).toBe('slices')
    const sixteen = { moves: 16, corner_rule: 'always' } as const
    expect(groundOf({ ...surface.spec, movement: sixteen })).toBe('sixteen')
    const { terrain: _, ...plane } = surface.spec
    expect(groundOf(plane)).toBe('plane')
    expect(groundOf({ ...plane, movement: sixteen })).toBe('sixteen')
    expect(groundAt(surface, [1, 2])).toBe(30)
    expect(groundAt(surface, [0, 2])).toBeNull()
  })
})

const raster = (width: number, height: number, cell: [number, number]) =>
  ({ width, height, cell }) as Survey

test.describe('parts of a raster', () => {
  test('what fits is taken as it is, what is larger is shrunk to 513 cells a side', () => {
    const small = raster(144, 144, [71, 93])
    expect(sizeOf(wholeOf(small), small, suggested(small))).toEqual([110, 144])
    const large = raster(1201, 3601, [30, 30])
    expect(sizeOf(wholeOf(large), large, suggested(large))).toEqual([171, 513])
    expect(sizeOf(wholeOf(large), large, { most: 256, square: false })).toEqual([85, 256])
    expect(sizeOf(wholeOf(large), large, { size: [7, 9], square: false })).toEqual([7, 9])
  })

  test('square cells keep the extent: their sides are the longer ones of the raster', () => {
    const oblong = raster(200, 100, [15, 30])
    const size = sizeOf(wholeOf(oblong), oblong, { most: null, square: true })
    expect(size).toEqual([100, 100])
    expect(cellOf(wholeOf(oblong), oblong, size)).toEqual([30, 30])
    expect(sizeOf(wholeOf(oblong), oblong, suggested(oblong))).toEqual([100, 100])
    const typed = (given: { width: number } | { height: number }, square: boolean) =>
      withSide([100, 100], given, square, wholeOf(oblong), oblong)
    expect([typed({ width: 50 }, true), typed({ height: 20 }, true)]).toEqual([
      [50, 50],
      [20, 20],
    ])
    expect(typed({ width: 50 }, false)).toEqual([50, 100])
    expect(sizeOf(wholeOf(oblong), oblong, { most: 50, square: true })).toEqual([50, 50])
  })

  test('a part is marked from any corner, lies inside and is two cells wide at least', () => {
    const small = raster(100, 50, [1, 1])
    const part = { x: 20, y: 10, width: 30, height: 20 }
    expect(cropBetween([0.2, 0.2], [0.5, 0.6], small)).toEqual(part)
    expect(cropBetween([0.5, 0.6], [0.2, 0.2], small)).toEqual(part)
    expect(cropBetween([-1, -1], [2, 2], small)).toEqual(wholeOf(small))
    expect(cropBetween([1, 1], [1, 1], small)).toEqual({ x: 98, y: 48, width: 2, height: 2 })
    expect(cropFits(part, small)).toBe(true)
    for (const wrong of [{ x: 71 }, { y: -1 }, { width: 1 }, { height: 41 }, { x: 0.5 }])
      expect(cropFits({ ...part, ...wrong }, small)).toBe(false)
  })
})

test('a picture is brighter where the ground faces north-west, and empty without data', () => {
  // A ridge from north to south: it rises to the middle and falls behind it.
  const ridge = Float32Array.from({ length: 49 }, (_, i) => 100 - 30 * Math.abs((i % 7) - 3))
  ridge[0] = NO
  const pixels = hillShade(ridge, 7, [30, 30])
  const green = (x: number, y: number) => pixels[4 * (7 * y + x) + 1] ?? 0
  expect(pixels[3]).toBe(0)
  expect(pixels[7]).toBe(255)
  expect(green(2, 3)).toBeGreaterThan(green(4, 3) + 20)
})
