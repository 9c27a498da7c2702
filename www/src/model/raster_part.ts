/** Which part of a raster is opened, and in how many cells. */
import type { Window as Crop, Survey } from '@pkg/formicarium'
import { limits } from './facts'

export type { Crop }
export type Size = [width: number, height: number]

/** In how many cells: as many as there are or fit, or as many as the reader says; `square`: made square, or as they come. */
export type Sampling = { square: boolean } & ({ most: number | null } | { size: Size })

/** Runs on larger maps take long. */
export const WATCHED_SIDE = 513
const LEAST_SIDE = 2
/** Sides that differ by less are the same to the eye and to every measure. */
const SAME = 0.005

interface Sides {
  width: number
  height: number
}

export const wholeOf = ({ width, height }: Sides): Crop => ({ x: 0, y: 0, width, height })

export const isWhole = (crop: Crop, { width, height }: Sides): boolean =>
  crop.width === width && crop.height === height

export function isSquare([x, y]: readonly [number, number]): boolean {
  return Math.abs(x / y - 1) < SAME
}

/** What is suggested: the raster as it is, as long as it can be watched, in cells that are square. */
export function suggested({ width, height }: Survey): Sampling {
  return { most: Math.max(width, height) > WATCHED_SIDE ? WATCHED_SIDE : null, square: true }
}

export function sizeOf(crop: Crop, survey: Survey, sampling: Sampling): Size {
  if ('size' in sampling) return sampling.size
  const { most, square } = sampling
  const [wide, high] = square ? squareCells(crop, survey) : [crop.width, crop.height]
  const shrink = Math.min(1, (most ?? limits.max_side) / Math.max(wide, high))
  return [rounded(wide * shrink), rounded(high * shrink)]
}

/** How many columns and rows of square cells, of the longer side of the raster's, cover the part; not rounded. */
function squareCells({ width, height }: Crop, { cell }: Survey): [wide: number, high: number] {
  if (isSquare(cell)) return [width, height]
  const side = Math.max(...cell)
  return [(width * cell[0]) / side, (height * cell[1]) / side]
}

/** The same with one side as the reader says; with square cells the other one follows. */
export function withSide(
  [width, height]: Size,
  given: { width: number } | { height: number },
  square: boolean,
  crop: Crop,
  survey: Survey,
): Size {
  const [wide, high] = squareCells(crop, survey)
  if ('width' in given) return [given.width, square ? rounded((given.width * high) / wide) : height]
  return [square ? rounded((given.height * wide) / high) : width, given.height]
}

/** Metres a cell across and down when a part is opened in so many cells. */
export function cellOf(crop: Crop, { cell }: Survey, [width, height]: Size): [number, number] {
  return [(crop.width * cell[0]) / width, (crop.height * cell[1]) / height]
}

export function cropFits({ x, y, width, height }: Crop, raster: Sides): boolean {
  return (
    [x, y, width, height].every(Number.isInteger) &&
    x >= 0 &&
    y >= 0 &&
    width >= LEAST_SIDE &&
    height >= LEAST_SIDE &&
    x + width <= raster.width &&
    y + height <= raster.height
  )
}

export function sizeFits(size: Size): boolean {
  return size.every((n) => Number.isInteger(n) && n >= LEAST_SIDE && n <= limits.max_side)
}

/** The cells between two points of the picture, each given as shares of its width and height; large enough to be a map. */
export function cropBetween(
  [x0, y0]: [number, number],
  [x1, y1]: [number, number],
  { width, height }: Survey,
): Crop {
  const [x, wide] = stretch(x0, x1, width)
  const [y, high] = stretch(y0, y1, height)
  return { x, y, width: wide, height: high }
}

function stretch(a: number, b: number, cells: number): [from: number, count: number] {
  const [low, high] = [Math.min(a, b), Math.max(a, b)].map((share) =>
    Math.min(1, Math.max(0, share)),
  )
  const from = Math.min(Math.floor((low ?? 0) * cells), Math.max(0, cells - LEAST_SIDE))
  const to = Math.ceil((high ?? 1) * cells)
  return [from, Math.min(cells - from, Math.max(LEAST_SIDE, to - from))]
}

function rounded(side: number): number {
  return Math.max(LEAST_SIDE, Math.round(side) || 0)
}
