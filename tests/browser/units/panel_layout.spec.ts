/** How panels share the room. */
import { expect, test } from '@playwright/test'
import { panelLayout } from '../../../www/src/model/panel_layout'

const FRAME = { head: 40, border: 2, gap: 6 }
const layout = (count: number, width: number, height: number, map = { width: 36, height: 22 }) =>
  panelLayout(count, { width, height }, map, FRAME)

test('maps come out as large as they can', () => {
  // Side by side each has 497 × 558, one above the other 998 × 255: scale 13.8 or 11.6.
  expect(layout(2, 1000, 600)).toEqual({ columns: 2, rowHeight: null })
  // 1.5 times as wide as high, and a map like a tower: side by side; a map like a river: one above the other.
  expect(layout(2, 900, 600, { width: 10, height: 40 }).columns).toBe(2)
  expect(layout(2, 900, 600, { width: 40, height: 10 }).columns).toBe(1)
  expect(layout(6, 1000, 580).columns).toBe(3)
  expect(layout(4, 1100, 700).columns).toBe(2)
})

test('one panel has all the room, however little that is', () => {
  expect(layout(1, 300, 90)).toEqual({ columns: 1, rowHeight: null })
})

test('more panels than the room holds are scrolled, each as high as its map wants', () => {
  const { columns, rowHeight } = layout(4, 378, 500)
  expect(columns).toBe(1)
  // 376 wide: the map wants 376 · 22 / 36 = 229.8, with head and border 271.
  expect(rowHeight).toBe(271)
  // Never higher than the room, or nobody could see it at once.
  expect(layout(4, 378, 500, { width: 10, height: 40 }).rowHeight).toBe(500)
})

test('maps of which cells are pressed are rather scrolled than small', () => {
  const pressed = (count: number, width: number, height: number) =>
    panelLayout(count, { width, height }, { width: 36, height: 22 }, FRAME, true)
  // Two below each other would have 137 each for their maps.
  expect(layout(2, 378, 364)).toEqual({ columns: 1, rowHeight: null })
  expect(pressed(2, 378, 364)).toEqual({ columns: 1, rowHeight: 271 })
  expect(pressed(4, 1100, 700)).toEqual({ columns: 2, rowHeight: null })
})
