/** Where the eye is: zoom and centre, shared by every panel so that maps can be compared cell by cell. All lengths in device pixels. */
import { signal } from '@preact/signals'

/** zoom 1 shows the whole map; the centre is a fraction of the map's width and height. */
export interface Viewpoint {
  zoom: number
  centreX: number
  centreY: number
}

export interface Size {
  width: number
  height: number
}

/** What a map is drawn on; `dpr`: device pixels a CSS pixel. */
export type CanvasSize = Size & { dpr: number }

/** Where one panel's canvas puts the map. */
export interface Placement {
  scale: number
  originX: number
  originY: number
}

export type Point = [number, number]

export const MOST_ZOOM = 64
/** From this size on cells are whole pixels wide, so that all look equal. */
const WHOLE_PIXELS = 6
/** Leaves an edge free. */
const ROOM = 0.97
/** How far markers of start and goals reach from the middle of their cell while cells are small; CSS pixels. */
const MARK = 11

const WHOLE_MAP: Viewpoint = { zoom: 1, centreX: 0.5, centreY: 0.5 }

export const viewpoint = signal<Viewpoint>(WHOLE_MAP)

export function fitView(): void {
  viewpoint.value = WHOLE_MAP
}

/** For buttons and keys: zooms about the centre. */
export function zoomBy(factor: number): void {
  const view = viewpoint.peek()
  viewpoint.value = settle({ ...view, zoom: limit(view.zoom * factor) })
}

export function placement(view: Viewpoint, canvas: CanvasSize, map: Size): Placement {
  const scale = wholeIfLarge(fitScale(canvas, map) * view.zoom)
  return {
    scale,
    originX: Math.round(canvas.width / 2 - view.centreX * map.width * scale),
    originY: Math.round(canvas.height / 2 - view.centreY * map.height * scale),
  }
}

/** The cell position under a canvas point, fractions included. */
export function toMap({ scale, originX, originY }: Placement, [x, y]: Point): Point {
  return [(x - originX) / scale, (y - originY) / scale]
}

/** Zooms so that the map position under `at` stays there. */
export function zoomAt(
  view: Viewpoint,
  factor: number,
  at: Point,
  canvas: CanvasSize,
  map: Size,
): Viewpoint {
  const zoom = limit(view.zoom * factor)
  const [mapX, mapY] = toMap(placement(view, canvas, map), at)
  const { scale } = placement({ ...view, zoom }, canvas, map)
  const centreX = (mapX + (canvas.width / 2 - at[0]) / scale) / map.width
  const centreY = (mapY + (canvas.height / 2 - at[1]) / scale) / map.height
  return settle({ zoom, centreX, centreY })
}

/** Shifts the map by a number of pixels. */
export function panBy(
  view: Viewpoint,
  dx: number,
  dy: number,
  canvas: CanvasSize,
  map: Size,
): Viewpoint {
  const { scale } = placement(view, canvas, map)
  const centreX = view.centreX - dx / scale / map.width
  const centreY = view.centreY - dy / scale / map.height
  return settle({ ...view, centreX, centreY })
}

/** The nearest view that shows `cell` with some room around it; the same object when it is shown already. */
export function reveal(view: Viewpoint, cell: Point, canvas: CanvasSize, map: Size): Viewpoint {
  const { scale, originX, originY } = placement(view, canvas, map)
  const margin = Math.min(2 * scale, canvas.width / 4, canvas.height / 4)
  const dx = shortfall(originX + cell[0] * scale, scale, canvas.width, margin)
  const dy = shortfall(originY + cell[1] * scale, scale, canvas.height, margin)
  if (view.zoom === 1 || (dx === 0 && dy === 0)) return view
  return panBy(view, dx, dy, canvas, map)
}

function shortfall(position: number, size: number, room: number, margin: number): number {
  if (position < margin) return margin - position
  return Math.min(0, room - margin - position - size)
}

/** Fully zoomed out is the whole map again; the centre never leaves the map. */
function settle(view: Viewpoint): Viewpoint {
  if (view.zoom <= 1) return WHOLE_MAP
  return { zoom: view.zoom, centreX: unit(view.centreX), centreY: unit(view.centreY) }
}

function limit(zoom: number): number {
  return Math.min(MOST_ZOOM, Math.max(1, zoom))
}

function unit(fraction: number): number {
  return Math.min(1, Math.max(0, fraction))
}

/** The whole map, and the markers of its outermost cells. */
function fitScale({ width, height, dpr }: CanvasSize, map: Size): number {
  const marked = (side: number, cells: number) => (side - 2 * MARK * dpr) / Math.max(1, cells - 1)
  const largest = Math.min(
    (ROOM * width) / map.width,
    (ROOM * height) / map.height,
    marked(width, map.width),
    marked(height, map.height),
  )
  return Math.max(0.05, largest)
}

function wholeIfLarge(scale: number): number {
  return scale >= WHOLE_PIXELS ? Math.floor(scale) : scale
}
