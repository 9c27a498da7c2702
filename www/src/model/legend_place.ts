/**
 * Where a legend stands over a map: out of its way. In full beside the map, or over walls alone; else as one line where it covers the
 * fewest free cells; never over the marker of start or goal. Lengths in CSS pixels.
 */
import type { Scenario } from './session'
import type { Size } from './viewpoint'

/** `full`: a title above its values; `line`: both in one line; `bar`: the values alone. */
export type LegendShape = 'full' | 'line' | 'bar'
export type LegendSide = 'right-bottom' | 'left-bottom' | 'right-top' | 'left-top'

export interface LegendPlace {
  shape: LegendShape
  side: LegendSide
}

/** A map as it lies on a stage: the corner of its first cell, and the side of a cell. */
export interface LaidMap {
  left: number
  top: number
  cell: number
}

/** From the edges of the stage (legend.css). */
const EDGE = 6
/** How far a marker reaches from the middle of its cell, and some room. */
const MARKER = 14
/** It moves only where that saves so much of what it covers. */
const WORTH_MOVING = 0.25

const SIDES: LegendSide[] = ['right-bottom', 'left-bottom', 'right-top', 'left-top']

/** In the order in which a scale bar takes them. */
const BAR_SIDES: LegendSide[] = ['left-bottom', 'right-bottom', 'left-top', 'right-top']

interface Box {
  left: number
  top: number
  right: number
  bottom: number
}

/** Null where it would cover a marker wherever it stood. `sizes`: what each shape takes; `before`: where it stands. */
export function legendPlace(
  stage: Size,
  map: LaidMap,
  now: Scenario,
  sizes: Record<LegendShape, Size>,
  before: LegendPlace | null,
): LegendPlace | null {
  const covers = ({ shape, side }: LegendPlace) =>
    coveredBy(boxAt(side, sizes[shape], stage), map, now)
  const places = (shapes: LegendShape[]) =>
    shapes
      .filter((shape) => sizes[shape].width + 2 * EDGE <= stage.width)
      .flatMap((shape) => SIDES.map((side) => ({ shape, side })))
  const clear = places(['full', 'line', 'bar']).find((place) => covers(place) === 0)
  if (clear) return clear
  const shape = 2 * sizes.line.width <= stage.width ? 'line' : 'bar'
  const ranked = places([shape])
    .map((place) => ({ place, covered: covers(place) }))
    .sort((a, b) => a.covered - b.covered)
  const best = ranked[0]
  if (!best || best.covered === Number.POSITIVE_INFINITY) return null
  const stays = ranked.find(({ place }) => place.side === before?.side && shape === before.shape)
  return stays && stays.covered * (1 - WORTH_MOVING) <= best.covered ? stays.place : best.place
}

/**
 * Where a scale bar stands: beside the legend, never over a marker, and where it covers the fewest free cells; it stays where it stood
 * as long as it may. Null where there is no such corner.
 */
export function barSide(
  stage: Size,
  map: LaidMap,
  now: Scenario,
  size: Size,
  legend: { side: LegendSide; size: Size } | null,
  before: LegendSide | null,
): LegendSide | null {
  const taken = legend && boxAt(legend.side, legend.size, stage)
  const covered = (side: LegendSide) => {
    const box = boxAt(side, size, stage)
    return taken && !areApart(box, taken) ? Number.POSITIVE_INFINITY : coveredBy(box, map, now)
  }
  const ranked = BAR_SIDES.map((side) => ({ side, covered: covered(side) }))
    .filter(({ covered }) => Number.isFinite(covered))
    .sort((a, b) => a.covered - b.covered)
  return ranked.find(({ side }) => side === before)?.side ?? ranked[0]?.side ?? null
}

const areApart = (a: Box, b: Box) =>
  a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top

function boxAt(side: LegendSide, { width, height }: Size, stage: Size): Box {
  const left = side.startsWith('left') ? EDGE : stage.width - EDGE - width
  const top = side.endsWith('top') ? EDGE : stage.height - EDGE - height
  return { left, top, right: left + width, bottom: top + height }
}

/** How many free cells; infinitely many where it reaches a marker. */
function coveredBy(box: Box, { left, top, cell }: LaidMap, now: Scenario): number {
  const { spec } = now
  for (const [x, y] of [spec.start, ...spec.goals.map(({ at }) => at)]) {
    const [middleX, middleY] = [left + (x + 0.5) * cell, top + (y + 0.5) * cell]
    const reach = Math.max(MARKER, cell / 2)
    const apartX = middleX + reach <= box.left || middleX - reach >= box.right
    const apartY = middleY + reach <= box.top || middleY - reach >= box.bottom
    if (!apartX && !apartY) return Number.POSITIVE_INFINITY
  }
  const first = (edge: number, from: number) => Math.max(0, Math.floor((edge - from) / cell))
  const end = (edge: number, from: number, most: number) =>
    Math.min(most, Math.ceil((edge - from) / cell))
  const [fromX, toX] = [first(box.left, left), end(box.right, left, spec.width)]
  const [fromY, toY] = [first(box.top, top), end(box.bottom, top, spec.height)]
  let free = 0
  for (let y = fromY; y < toY; y++)
    for (let x = fromX; x < toX; x++) free += Number(now.cells[y * spec.width + x] === 0)
  return free
}
