/** The lattice of a figure while it is dragged, and its cells while they are corrected. */
import type { Lattice } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import {
  cellsBetween,
  corrected,
  ended,
  nextUnsure,
  painted,
  withLattice,
} from '../../../www/src/dialogs/figure_draft'
import {
  cellUnder,
  divided,
  dragged,
  handlePlace,
  latticeOver,
  moved,
  placeAt,
} from '../../../www/src/dialogs/figure_lattice'

const LEANING: Lattice = {
  x0: 10,
  y0: 20,
  dx: 8,
  dy: 6,
  shear_x: 0.5,
  shear_y: -0.4,
  columns: 5,
  rows: 4,
}

function expectNear(found: readonly number[], wanted: readonly number[]): void {
  for (const [i, value] of wanted.entries()) expect(found[i]).toBeCloseTo(value, 9)
}

test('a dragged corner is where it was dragged, and the opposite one where it was', () => {
  for (const u of [0, 1] as const)
    for (const v of [0, 1] as const) {
      const [x, y] = handlePlace(LEANING, [u, v])
      const after = dragged(LEANING, [u, v], [3, -2])
      expectNear(handlePlace(after, [u, v]), [x + 3, y - 2])
      const opposite = [u === 0 ? 1 : 0, v === 0 ? 1 : 0] as const
      expectNear(handlePlace(after, opposite), handlePlace(LEANING, opposite))
    }
})

test('an edge moves along one side alone, and cells stay large enough', () => {
  const right = dragged(LEANING, [1, 0.5], [10, 0])
  expect([right.dy, right.shear_x, right.columns]).toEqual([6, 0.5, 5])
  expect(right.dx).toBeGreaterThan(LEANING.dx)
  expectNear([right.x0, right.y0], [10, 20])
  expect(dragged(LEANING, [1, 1], [-1000, -1000])).toMatchObject({ dx: 3, dy: 3 })
})

test('another number of columns and rows keeps the frame; a move keeps all else', () => {
  const fine = divided(LEANING, 10, 2)
  for (const corner of [
    [0, 0],
    [1, 0],
    [1, 1],
  ] as const)
    expectNear(handlePlace(fine, corner), handlePlace(LEANING, corner))
  expect(moved(LEANING, [1, 2])).toEqual({ ...LEANING, x0: 11, y0: 22 })
  expect(latticeOver(200, 30)).toMatchObject({ columns: 20, rows: 10, dx: 10, dy: 3 })
})

test('a place is the cell that it lies in', () => {
  for (const cell of [
    [0, 0],
    [4, 0],
    [2, 3],
  ] as const)
    expect(cellUnder(LEANING, placeAt(LEANING, cell[0] + 0.5, cell[1] + 0.5))).toEqual(cell)
  expect(cellUnder(LEANING, placeAt(LEANING, -0.1, 1))).toBeNull()
  expect(cellUnder(LEANING, placeAt(LEANING, 5.1, 1))).toBeNull()
})

test('corrections lie over what was read; there is one start', () => {
  const read = Uint8Array.from([2, 0, 1, 5, 0, 0, 5, 3, 0])
  const draft = painted(withLattice({ ...LEANING, columns: 3, rows: 3 }), [3, 4], 'wall')
  const classes = corrected(read, draft)
  expect([...classes]).toEqual([2, 0, 1, 1, 1, 0, 5, 3, 0])
  expect([...corrected(read, ended(draft, classes, 5, 'start'))]).toEqual([
    0, 0, 1, 1, 1, 2, 5, 3, 0,
  ])
  expect([nextUnsure(read, -1), nextUnsure(read, 3), nextUnsure(read, 6)]).toEqual([3, 6, 3])
  expect(nextUnsure(Uint8Array.from([0, 1]), 0)).toBe(-1)
  expect(cellsBetween([0, 0], [3, 1])).toEqual([
    [0, 0],
    [1, 0],
    [2, 1],
    [3, 1],
  ])
})
