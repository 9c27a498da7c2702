/** The cells of a map as one path a colour. */
import { expect, test } from '@playwright/test'
import { cellPaths } from '../../../www/src/figures/map_cells'

/** One letter a cell; a dot is clear. */
function pixels(rows: string[]): Uint8ClampedArray {
  const colours: Record<string, number[]> = {
    '.': [0, 0, 0, 0],
    w: [255, 255, 255, 255],
    b: [0, 0, 0, 255],
    r: [255, 0, 16, 255],
  }
  return Uint8ClampedArray.from([...rows.join('')].flatMap((cell) => colours[cell] ?? []))
}

test('neighbours of a row are one rectangle; the commonest colour lies under all', () => {
  expect(cellPaths(pixels(['wwbb', 'wwwr']), 4, 10)).toEqual({
    base: '#ffffff',
    paths: [
      { colour: '#000000', d: 'M2 0h2v1h-2z' },
      { colour: '#ff0010', d: 'M3 1h1v1h-1z' },
    ],
  })
})

test('a rectangle never goes on in the next row', () => {
  expect(cellPaths(pixels(['wwwb', 'bwww']), 4, 10)?.paths).toEqual([
    { colour: '#000000', d: 'M3 0h1v1h-1zM0 1h1v1h-1z' },
  ])
})

test('what is clear has nothing under it', () => {
  const { base, paths } = cellPaths(pixels(['w.', 'ww']), 2, 10) ?? {}
  expect(base).toBeNull()
  expect(paths).toEqual([{ colour: '#ffffff', d: 'M0 0h1v1h-1zM0 1h2v1h-2z' }])
})

test('too many rectangles are none', () => {
  expect(cellPaths(pixels(['wbwb', 'bwbw']), 4, 3)).toBeNull()
  expect(cellPaths(pixels(['wbwb', 'bwbw']), 4, 4)).not.toBeNull()
})
