/** What lies under ants and markers: raster, grid, best path; and the cursor over them. Pure functions of the view. */
import type { ScenarioSpec } from '@pkg/formicarium'
import type { PanelView } from '../model/messages'

type Context = OffscreenCanvasRenderingContext2D

/** CSS pixels a cell must have before grid lines help rather than hide. */
const GRID_FROM = 12

export const MAP_COLOURS = {
  light: {
    grid: 'rgba(60, 48, 30, 0.09)',
    hatch: ['#e4e7e6', '#b9c1be'],
    halo: 'rgba(255, 255, 255, 0.92)',
    ring: '#ffffff',
    cursor: '#1c1712',
  },
  dark: {
    grid: 'rgba(255, 244, 225, 0.07)',
    hatch: ['#161d1c', '#33403d'],
    halo: 'rgba(12, 14, 20, 0.85)',
    ring: '#14161c',
    cursor: '#fff3dc',
  },
}

/** Cells stay crisp squares when magnified; when a cell is under a pixel, averaging keeps thin walls visible. */
export function drawRaster(context: Context, view: PanelView, raster: OffscreenCanvas): void {
  context.imageSmoothingEnabled = view.scale < 1
  context.imageSmoothingQuality = 'high'
  const width = raster.width * view.scale
  const height = raster.height * view.scale
  context.drawImage(raster, view.originX, view.originY, width, height)
}

/** Hatching under the raster, seen where there is no data, and where a robot has no room. It moves with the map; its strokes keep their width at any zoom. */
export function drawHatch(
  context: Context,
  view: PanelView,
  { width, height }: ScenarioSpec,
): void {
  const { scale, originX, originY, dpr } = view
  const pattern = context.createPattern(hatchTile(view.theme, Math.round(8 * dpr)), 'repeat')
  if (pattern === null) return
  pattern.setTransform(new DOMMatrix([1, 0, 0, 1, originX, originY]))
  context.fillStyle = pattern
  context.fillRect(originX, originY, width * scale, height * scale)
}

const tiles = new Map<string, OffscreenCanvas>()

function hatchTile(theme: PanelView['theme'], size: number): OffscreenCanvas {
  const known = tiles.get(`${theme} ${size}`)
  if (known) return known
  const tile = new OffscreenCanvas(size, size)
  const context = tile.getContext('2d')
  const [ground, stroke] = MAP_COLOURS[theme].hatch
  if (context && ground && stroke) {
    context.fillStyle = ground
    context.fillRect(0, 0, size, size)
    context.strokeStyle = stroke
    context.lineWidth = size / 6
    for (const shift of [-size, 0, size]) {
      context.moveTo(shift - 1, size + 1)
      context.lineTo(shift + size + 1, -1)
    }
    context.stroke()
  }
  tiles.set(`${theme} ${size}`, tile)
  return tile
}

export function drawGrid(context: Context, view: PanelView, { width, height }: ScenarioSpec): void {
  const { scale, originX, originY, dpr } = view
  if (scale < GRID_FROM * dpr) return
  const right = originX + width * scale
  const bottom = originY + height * scale
  const line = Math.max(1, Math.round(dpr / 2))
  context.fillStyle = MAP_COLOURS[view.theme].grid
  for (let x = originX; x <= right + 0.5; x += scale) {
    if (x >= 0 && x <= view.width) context.fillRect(Math.round(x), originY, line, bottom - originY)
  }
  for (let y = originY; y <= bottom + 0.5; y += scale) {
    if (y >= 0 && y <= view.height) context.fillRect(originX, Math.round(y), right - originX, line)
  }
}

/** `path`: x0, y0, x1, y1, …; its cells need not be neighbours. */
export function drawPath(context: Context, view: PanelView, path: Uint32Array): void {
  if (path.length < 4) return
  const line = new Path2D()
  for (let i = 0; i + 1 < path.length; i += 2) {
    line.lineTo(...centre(view, path[i] ?? 0, path[i + 1] ?? 0))
  }
  const width = Math.min(6 * view.dpr, Math.max(2.25 * view.dpr, 0.24 * view.scale))
  context.lineJoin = 'round'
  context.lineCap = 'round'
  context.strokeStyle = MAP_COLOURS[view.theme].halo
  context.lineWidth = width + 3 * view.dpr
  context.stroke(line)
  context.strokeStyle = view.colour
  context.lineWidth = width
  context.stroke(line)
}

/** The cell cursor: a tint under the pointer, a double ring for the keyboard. */
export function drawCursor(context: Context, view: PanelView): void {
  if (view.cursor === null) return
  const { scale, dpr } = view
  const size = Math.max(scale, view.cursorFocus ? 9 * dpr : 3 * dpr)
  const [x, y] = centre(view, ...view.cursor)
  const colours = MAP_COLOURS[view.theme]
  if (!view.cursorFocus) {
    context.globalAlpha = 0.16
    context.fillStyle = colours.cursor
    context.fillRect(x - size / 2, y - size / 2, size, size)
    context.globalAlpha = 1
    return
  }
  for (const [colour, width, grow] of [
    [colours.ring, 5 * dpr, 1.5 * dpr],
    [colours.cursor, 2 * dpr, 1.5 * dpr],
  ] as const) {
    context.strokeStyle = colour
    context.lineWidth = width
    context.strokeRect(x - size / 2 - grow, y - size / 2 - grow, size + 2 * grow, size + 2 * grow)
  }
}

export function centre(view: PanelView, x: number, y: number): [number, number] {
  return [view.originX + (x + 0.5) * view.scale, view.originY + (y + 0.5) * view.scale]
}
