/** Everything on the stage but the ants: raster, grid, best path, start and goal, cursor. Pure functions of the view. */
import type { ScenarioSpec } from '@pkg/formicarium'
import type { View } from '../messages'

type Context = OffscreenCanvasRenderingContext2D

const TURN = 2 * Math.PI
/** CSS pixels a cell must have before grid lines help rather than hide. */
const GRID_FROM = 12

const COLOURS = {
  light: {
    grid: 'rgba(60, 48, 30, 0.09)',
    halo: 'rgba(255, 255, 255, 0.92)',
    ring: '#ffffff',
    cursor: '#1c1712',
  },
  dark: {
    grid: 'rgba(255, 244, 225, 0.07)',
    halo: 'rgba(12, 14, 20, 0.85)',
    ring: '#14161c',
    cursor: '#fff3dc',
  },
}
const START = { light: '#0c8a4d', dark: '#3ddc84' }
const GOAL = { light: '#d3263a', dark: '#ff6b76' }

/** Cells stay crisp squares when magnified; when a cell is under a pixel, averaging keeps thin walls visible. */
export function drawRaster(context: Context, view: View, raster: OffscreenCanvas): void {
  context.imageSmoothingEnabled = view.scale < 1
  context.imageSmoothingQuality = 'high'
  const width = raster.width * view.scale
  const height = raster.height * view.scale
  context.drawImage(raster, view.originX, view.originY, width, height)
}

export function drawGrid(context: Context, view: View, { width, height }: ScenarioSpec): void {
  const { scale, originX, originY, dpr } = view
  if (scale < GRID_FROM * dpr) return
  const right = originX + width * scale
  const bottom = originY + height * scale
  const line = Math.max(1, Math.round(dpr / 2))
  context.fillStyle = COLOURS[view.theme].grid
  for (let x = originX; x <= right + 0.5; x += scale) {
    if (x >= 0 && x <= view.width) context.fillRect(Math.round(x), originY, line, bottom - originY)
  }
  for (let y = originY; y <= bottom + 0.5; y += scale) {
    if (y >= 0 && y <= view.height) context.fillRect(originX, Math.round(y), right - originX, line)
  }
}

/** `path`: x0, y0, x1, y1, … */
export function drawPath(context: Context, view: View, path: Uint32Array): void {
  if (path.length < 4) return
  const line = new Path2D()
  for (let i = 0; i + 1 < path.length; i += 2) {
    line.lineTo(...centre(view, path[i] ?? 0, path[i + 1] ?? 0))
  }
  const width = Math.min(6 * view.dpr, Math.max(2.25 * view.dpr, 0.24 * view.scale))
  context.lineJoin = 'round'
  context.lineCap = 'round'
  context.strokeStyle = COLOURS[view.theme].halo
  context.lineWidth = width + 3 * view.dpr
  context.stroke(line)
  context.strokeStyle = view.colour
  context.lineWidth = width
  context.stroke(line)
}

/** The start is a green disc with a hole, the goal a red diamond: told apart by shape as well as by colour. */
export function drawEnds(context: Context, view: View, spec: ScenarioSpec): void {
  const radius = markRadius(view)
  for (const goal of spec.goals) drawDiamond(context, view, goal.at, radius)
  drawDisc(context, view, spec.start, radius)
}

/** Never smaller than can be seen and grasped, even when a cell is a pixel. */
export function markRadius({ scale, dpr }: Pick<View, 'scale' | 'dpr'>): number {
  return Math.min(16 * dpr, Math.max(6 * dpr, 0.4 * scale))
}

function drawDisc(context: Context, view: View, at: [number, number], radius: number): void {
  const [x, y] = centre(view, ...at)
  const colours = COLOURS[view.theme]
  context.fillStyle = colours.ring
  context.beginPath()
  context.arc(x, y, radius + 1.5 * view.dpr, 0, TURN)
  context.fill()
  context.fillStyle = START[view.theme]
  context.beginPath()
  context.arc(x, y, radius, 0, TURN)
  context.fill()
  context.fillStyle = colours.ring
  context.beginPath()
  context.arc(x, y, 0.36 * radius, 0, TURN)
  context.fill()
}

function drawDiamond(context: Context, view: View, at: [number, number], radius: number): void {
  const [x, y] = centre(view, ...at)
  const reach = 1.18 * radius
  context.beginPath()
  context.moveTo(x, y - reach)
  context.lineTo(x + reach, y)
  context.lineTo(x, y + reach)
  context.lineTo(x - reach, y)
  context.closePath()
  context.lineJoin = 'round'
  context.strokeStyle = COLOURS[view.theme].ring
  context.lineWidth = 3 * view.dpr
  context.stroke()
  context.fillStyle = GOAL[view.theme]
  context.fill()
}

/** A tint under the pointer, a double ring for the keyboard. */
export function drawCursor(context: Context, view: View): void {
  if (view.cursor === null) return
  const { scale, dpr } = view
  const size = Math.max(scale, view.cursorFocus ? 9 * dpr : 3 * dpr)
  const [x, y] = centre(view, ...view.cursor)
  const colours = COLOURS[view.theme]
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

function centre(view: View, x: number, y: number): [number, number] {
  return [view.originX + (x + 0.5) * view.scale, view.originY + (y + 0.5) * view.scale]
}
