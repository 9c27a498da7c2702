import { expect, test } from '@playwright/test'
import { nearest, profileOf } from '../../../www/src/charts/profile_data'
import { Ground } from '../../../www/src/model/relief_ground'
import { eye, orbit, resetEye, shiftEye, turned } from '../../../www/src/relief/eye'
import { terrainOf } from './sessions'

const groundOf = (width: number, heights: number[], unit = 1) => {
  const { scenario } = terrainOf(width, heights.length / width, Float32Array.from(heights))
  scenario.spec.terrain = { vertical_unit: unit }
  scenario.spec.resolution = 1
  return new Ground(scenario)
}

test.describe('the ground', () => {
  test('is interpolated between the centres of cells', () => {
    const ground = groundOf(2, [10, 20, 30, 60])
    expect([ground.lowest, ground.highest, ground.span]).toEqual([10, 60, 50])
    expect(ground.between(0.5, 0.5)).toBe(0)
    expect(ground.between(1, 0.5)).toBe(5)
    expect(ground.between(1, 1)).toBe(20)
    // Beyond the outermost centres it is level.
    expect(ground.between(0, 0)).toBe(0)
    expect(ground.between(2, 2)).toBe(50)
  })

  test('is met by rays from above and from the side, and missed beside the map', () => {
    const level = groundOf(3, [5, 5, 5, 5, 5, 5])
    const below = level.hit([1.2, 10, 0.7], [0, -1, 0], 1)
    expect(below?.map((part) => Number(part.toFixed(3)))).toEqual([1.2, 0, 0.7])
    expect(level.hit([-1, 10, 0.7], [0, -1, 0], 1)).toBeNull()
    // Rises by 1 a cell to the east: 1.5 high at 2.0, seen twice as high at 1.25.
    const ramp = groundOf(6, [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5])
    expect(ramp.hit([-5, 1.5, 1], [1, 0, 0], 1)?.[0]).toBeCloseTo(2, 3)
    expect(ramp.hit([-5, 1.5, 1], [1, 0, 0], 2)?.[0]).toBeCloseTo(1.25, 3)
    expect(ramp.hit([-5, 6, 1], [1, 0, 0], 1)).toBeNull()
  })

  test('hides what is behind it', () => {
    const hill = Array.from({ length: 30 * 5 }, (_, i) => (i % 30 === 15 ? 20 : 0))
    const ground = groundOf(30, hill)
    expect(ground.hides([25, 0, 2.5], [-40, 10, 2.5], 1)).toBe(true)
    expect(ground.hides([5, 0, 2.5], [-40, 10, 2.5], 1)).toBe(false)
    expect(ground.hides([25, 0, 2.5], [24, 200, 2.5], 1)).toBe(false)
  })

  test('has holes where there is no data', () => {
    const ground = groundOf(3, [1, Number.NaN, 3, 1, Number.NaN, 3])
    expect([ground.lowest, ground.highest]).toEqual([1, 3])
    expect(ground.between(1.2, 0.5)).toBeNaN()
    expect(ground.hit([1.5, 9, 0.5], [0, -1, 0], 1)).toBeNull()
  })
})

test.describe('the eye', () => {
  test.beforeEach(resetEye)

  test('turns what keys mean along with the map', () => {
    eye.value = { ...eye.value, azimuth: 0 }
    expect(turned([0, -1])).toEqual([0, -1])
    // A quarter round one looks to the west: away is west, right is north.
    orbit(Math.PI / 2, 0)
    expect(turned([0, -1])).toEqual([-1, 0])
    expect(turned([1, 0])).toEqual([0, -1])
    shiftEye(0, 0.1, 20, 10)
    expect([eye.value.centreX, eye.value.centreY]).toEqual([0.4, 0.5])
  })

  test('never goes under the ground nor over its zenith, and looks at the map', () => {
    orbit(0, 9)
    expect(eye.value.elevation).toBeLessThan(Math.PI / 2)
    orbit(0, -9)
    expect(eye.value.elevation).toBeGreaterThan(0)
    shiftEye(50, 50, 10, 10)
    for (const part of [eye.value.centreX, eye.value.centreY]) expect([0, 1]).toContain(part)
  })
})

test.describe('a profile', () => {
  // As src/map/relief.rs works it out by hand: half a metre per unit.
  const ground = groundOf(3, [0, 2, 6, 4, 8, 0], 0.5)

  test('follows the ground through the cells that a segment passes', () => {
    const path = Uint32Array.of(0, 0, 2, 1)
    const {
      distances,
      altitudes,
      ground: below,
    } = profileOf(path, Float64Array.of(0, 0), ground, false)
    expect(distances).toEqual([0, Math.sqrt(5) / 2, Math.sqrt(5)])
    expect(altitudes).toEqual([0, 2.5, 0])
    expect(below).toBeNull()
  })

  test('by slices goes straight from level to level, over the ground', () => {
    const path = Uint32Array.of(0, 0, 2, 1)
    const profile = profileOf(path, Float64Array.of(4, 8), ground, true)
    expect(profile.altitudes).toEqual([4, 6, 8])
    expect(profile.ground).toEqual([0, 2.5, 0])
    expect([nearest(profile, -1), nearest(profile, 1), nearest(profile, 9)]).toEqual([0, 1, 2])
  })
})
