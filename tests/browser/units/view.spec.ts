import { expect, test } from '@playwright/test'
import { markRadius } from '../../../www/src/drawing/mark_radius'
import {
  MOST_ZOOM,
  type Point,
  panBy,
  placement,
  reveal,
  toMap,
  type Viewpoint,
  zoomAt,
} from '../../../www/src/model/viewpoint'

const WHOLE: Viewpoint = { zoom: 1, centreX: 0.5, centreY: 0.5 }
const map = { width: 36, height: 22 }
const canvas = { width: 640, height: 420, dpr: 1 }

test.describe('view', () => {
  test('the whole map fits every canvas, with cells of whole pixels where there is room', () => {
    for (const size of [
      canvas,
      { width: 390, height: 300, dpr: 1 },
      { width: 50, height: 900, dpr: 1 },
      { width: 1, height: 1, dpr: 1 },
    ]) {
      for (const shape of [map, { width: 512, height: 512 }, { width: 1, height: 4096 }]) {
        const { scale, originX, originY } = placement(WHOLE, size, shape)
        expect(scale).toBeGreaterThan(0)
        if (size.width === 1) continue
        expect(originX).toBeGreaterThanOrEqual(0)
        expect(originY).toBeGreaterThanOrEqual(0)
        expect(originX + scale * shape.width).toBeLessThanOrEqual(size.width + 1)
        expect(originY + scale * shape.height).toBeLessThanOrEqual(size.height + 1)
        if (scale >= 6) expect(Number.isInteger(scale)).toBe(true)
      }
    }
  })

  test('markers of the outermost cells are never cut off, however small the cells', () => {
    for (const dpr of [1, 2, 3])
      for (const side of [180, 390, 640])
        for (const cells of [2, 20, 36, 100, 513]) {
          const size = { width: side * dpr, height: side * dpr, dpr }
          const { scale, originX } = placement(WHOLE, size, { width: cells, height: cells })
          for (const several of [false, true]) {
            // A diamond is the widest of them, and has a ring.
            const reach = 1.18 * markRadius({ scale, dpr }, several) + 1.5 * dpr
            expect(originX + 0.5 * scale - reach).toBeGreaterThanOrEqual(-1)
            expect(originX + (cells - 0.5) * scale + reach).toBeLessThanOrEqual(size.width + 1)
          }
        }
  })

  test('zooming keeps what is under the pointer there', () => {
    const at: Point = [200, 150]
    let view = WHOLE
    for (let i = 0; i < 12; i++) {
      const before = toMap(placement(view, canvas, map), at)
      view = zoomAt(view, 1.3, at, canvas, map)
      const after = toMap(placement(view, canvas, map), at)
      expect(Math.abs(after[0] - before[0])).toBeLessThan(0.1)
      expect(Math.abs(after[1] - before[1])).toBeLessThan(0.1)
    }
  })

  test('zoom has limits, and fully out is the whole map', () => {
    expect(zoomAt(WHOLE, 1e9, [0, 0], canvas, map).zoom).toBe(MOST_ZOOM)
    expect(zoomAt({ zoom: 3, centreX: 0.1, centreY: 0.9 }, 0.01, [9, 9], canvas, map)).toEqual(
      WHOLE,
    )
  })

  test('the map cannot be lost by panning', () => {
    const view = panBy({ zoom: 4, centreX: 0.5, centreY: 0.5 }, 1e6, -1e6, canvas, map)
    expect(view).toEqual({ zoom: 4, centreX: 0, centreY: 1 })
  })

  test('the keyboard cursor is brought into view', () => {
    const view = reveal({ zoom: 6, centreX: 0.1, centreY: 0.1 }, [35, 21], canvas, map)
    const { scale, originX, originY } = placement(view, canvas, map)
    expect(originX + 35 * scale).toBeLessThan(canvas.width)
    expect(originY + 21 * scale).toBeLessThan(canvas.height)
    expect(reveal(WHOLE, [0, 0], canvas, map)).toBe(WHOLE)
  })
})
