/** Sets of cells that tools draw: as stretches of rows, so that large ones stay small. */
import type { Cell } from './cell'
import { isInside, lineCells } from './edit'
import type { Scenario } from './session'

/** A stretch of a row, ends included. Those of one set may overlap. */
export interface Span {
  y: number
  from: number
  to: number
}

export interface Sides {
  width: number
  height: number
}

/** A square of so many cells a side about a cell; an even one reaches one further to the right and down. */
export function squareAbout([x, y]: Cell, side: number, map: Sides): Span[] {
  const before = Math.floor((side - 1) / 2)
  return areaSpans({ x: x - before, y: y - before, width: side, height: side }, map)
}

/** The way of a brush of this size along a straight line. */
export function lineSpans(from: Cell, to: Cell, side: number, map: Sides): Span[] {
  return lineCells(from, to).flatMap((cell) => squareAbout(cell, side, map))
}

/** The border of a rectangle with these corners, drawn with a brush of this size. */
export function borderSpans([x0, y0]: Cell, [x1, y1]: Cell, side: number, map: Sides): Span[] {
  const corners: Cell[] = [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ]
  return corners.flatMap((corner, i) =>
    lineSpans(corner, corners[(i + 1) % corners.length] ?? corner, side, map),
  )
}

/** A part of a map. */
export interface Area extends Sides {
  x: number
  y: number
}

/** The rectangle with these corners, in either order. */
export function areaBetween([x0, y0]: Cell, [x1, y1]: Cell): Area {
  const [x, y] = [Math.min(x0, x1), Math.min(y0, y1)]
  return { x, y, width: Math.abs(x1 - x0) + 1, height: Math.abs(y1 - y0) + 1 }
}

/** As much of a part as lies on the map. */
export function areaSpans({ x, y, width, height }: Area, map: Sides): Span[] {
  const [from, to] = [Math.max(0, x), Math.min(map.width, x + width) - 1]
  const [top, bottom] = [Math.max(0, y), Math.min(map.height, y + height) - 1]
  if (from > to) return []
  return Array.from({ length: Math.max(0, bottom - top + 1) }, (_, i) => ({ y: top + i, from, to }))
}

/** The nearest cell to `to` in one of eight directions from `from`. */
export function straightened([x0, y0]: Cell, [x1, y1]: Cell): Cell {
  const [dx, dy] = [x1 - x0, y1 - y0]
  const [wide, high] = [Math.abs(dx), Math.abs(dy)]
  if (high <= wide * HALF_OF_45) return [x1, y0]
  if (wide <= high * HALF_OF_45) return [x0, y1]
  return squared([x0, y0], [x1, y1])
}

const HALF_OF_45 = Math.SQRT2 - 1

/** The corner of a square, as large as the longer side. */
export function squared([x0, y0]: Cell, [x1, y1]: Cell): Cell {
  const side = Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0))
  return [x0 + (x1 < x0 ? -side : side), y0 + (y1 < y0 ? -side : side)]
}

/**
 * All cells that straight steps lead to from here without leaving walls, or without entering them; of other values than these, those that
 * have the same one.
 */
export function floodSpans(
  scenario: Scenario,
  at: Cell,
  values: ArrayLike<number> = scenario.cells,
): Span[] {
  if (!isInside(scenario, at)) return []
  const { width, height } = scenario.spec
  const wanted = values[at[1] * width + at[0]]
  const seen = new Uint8Array(scenario.cells.length)
  const fits = (x: number, y: number) =>
    values[y * width + x] === wanted && seen[y * width + x] === 0
  const spans: Span[] = []
  const waiting: Cell[] = [at]
  for (let cell = waiting.pop(); cell; cell = waiting.pop()) {
    const [x, y] = cell
    if (!fits(x, y)) continue
    let [from, to] = [x, x]
    while (from > 0 && fits(from - 1, y)) from--
    while (to < width - 1 && fits(to + 1, y)) to++
    seen.fill(1, y * width + from, y * width + to + 1)
    spans.push({ y, from, to })
    for (const next of [y - 1, y + 1]) {
      if (next < 0 || next >= height) continue
      // The first cell of every stretch beside this one stands for all of it.
      for (let i = from; i <= to; i++)
        if (fits(i, next) && (i === from || !fits(i - 1, next))) waiting.push([i, next])
    }
  }
  return spans
}

/** The numbers of the cells, row by row from the upper left; where spans overlap, more than once. */
export function numbersOf(spans: Span[], { width }: Sides): Uint32Array {
  const numbers = new Uint32Array(spans.reduce((sum, { from, to }) => sum + to - from + 1, 0))
  let count = 0
  for (const { y, from, to } of spans)
    for (let x = from; x <= to; x++) numbers[count++] = y * width + x
  return numbers
}
