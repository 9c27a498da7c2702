/**
 * Contour lines over a terrain. They are stroked into a picture somewhat larger than the view, which serves until the reader has moved
 * beyond it: stroking them anew in every frame would cost more than all the rest. While the zoom changes, the old picture is
 * stretched; a moment later there is a crisp one. Lives in the worker.
 */
import type { PanelView } from '../model/messages'
import type { ContourData } from '../model/terrain'

type Context = OffscreenCanvasRenderingContext2D

const COLOURS = {
  light: { line: 'rgba(78, 58, 34, 0.34)', main: 'rgba(78, 58, 34, 0.62)', text: '#55402a' },
  dark: { line: 'rgba(232, 220, 196, 0.2)', main: 'rgba(232, 220, 196, 0.42)', text: '#cfc3ad' },
}
const HALO = { light: 'rgba(244, 241, 232, 0.85)', dark: 'rgba(24, 28, 28, 0.85)' }

/** One in so many lines is stronger and labelled with its height. */
const MAIN = 5
/** How far the picture reaches beyond the view, as a share of it. */
const MARGIN = 0.25
/** A zoom has ended when it has stood still for so long. */
const SETTLED_MS = 110
/** Shorter parts of a line are left out. Device pixels. */
const SHORTEST = 1.3
/** Between two labels. CSS pixels. */
const LABEL_EVERY = 380

interface Picture {
  canvas: OffscreenCanvas
  scale: number
  theme: PanelView['theme']
  dpr: number
  /** Where the picture's upper left corner lies on the map, in cells. */
  x: number
  y: number
}

export class ContourLayer {
  private data: ContourData | null = null
  private picture: Picture | null = null
  private timer = 0

  constructor(
    private readonly trace: () => ContourData,
    /** Whether some cells have no data. */
    readonly hasHoles: boolean,
  ) {}

  /** `again` is called when there is a better picture. */
  draw(context: Context, view: PanelView, again: () => void): void {
    if (this.picture === null || !suits(this.picture, view)) this.picture = this.stroke(view)
    else if (this.picture.scale !== view.scale) this.strokeLater(view, again)
    const { canvas, scale, x, y } = this.picture
    const zoom = view.scale / scale
    context.imageSmoothingEnabled = zoom !== 1
    context.drawImage(
      canvas,
      Math.round(view.originX + x * view.scale),
      Math.round(view.originY + y * view.scale),
      canvas.width * zoom,
      canvas.height * zoom,
    )
  }

  private strokeLater(view: PanelView, again: () => void): void {
    clearTimeout(this.timer)
    this.timer = self.setTimeout(() => {
      this.picture = this.stroke(view)
      again()
    }, SETTLED_MS)
  }

  private stroke(view: PanelView): Picture {
    clearTimeout(this.timer)
    this.data ??= this.trace()
    const { scale, theme, dpr } = view
    const left = Math.round(MARGIN * view.width)
    const top = Math.round(MARGIN * view.height)
    const size = { width: view.width + 2 * left, height: view.height + 2 * top }
    const canvas = new OffscreenCanvas(size.width, size.height)
    const context = canvas.getContext('2d')
    const x = -(view.originX + left) / scale
    const y = -(view.originY + top) / scale
    if (context) strokeLines(context, linesWithin(this.data, { scale, x, y, ...size }), view)
    return { canvas, scale, theme, dpr, x, y }
  }
}

/** Whether the view lies within the picture; one of another zoom may leave an edge free for a moment. */
function suits({ canvas, scale, theme, dpr, x, y }: Picture, view: PanelView): boolean {
  if (theme !== view.theme || dpr !== view.dpr) return false
  if (scale !== view.scale) return true
  const left = view.originX + x * scale
  const top = view.originY + y * scale
  const covers =
    left <= 1 &&
    top <= 1 &&
    left + canvas.width >= view.width - 1 &&
    top + canvas.height >= view.height - 1
  // A picture made for a much larger view wastes memory.
  return covers && canvas.width <= 3 * view.width
}

interface Line {
  main: boolean
  height: number
  /** x0, y0, … in pixels of the picture. */
  at: number[]
}

interface Frame {
  scale: number
  x: number
  y: number
  width: number
  height: number
}

/** The lines that touch the frame, without parts that are too short to see. */
function linesWithin({ points, ends, levels, interval }: ContourData, frame: Frame): Line[] {
  const lines: Line[] = []
  let begin = 0
  for (const [i, end] of ends.entries()) {
    const level = levels[i] ?? 0
    const at = project(points.subarray(2 * begin, 2 * end), frame)
    if (at) lines.push({ main: level % MAIN === 0, height: level * interval, at })
    begin = end
  }
  return lines
}

function project(points: Float32Array, { scale, x, y, width, height }: Frame): number[] | null {
  const at: number[] = []
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity]
  let [lastX, lastY] = [Infinity, Infinity]
  for (let i = 0; i + 1 < points.length; i += 2) {
    const px = ((points[i] ?? 0) - x) * scale
    const py = ((points[i + 1] ?? 0) - y) * scale
    const near = Math.abs(px - lastX) + Math.abs(py - lastY) < SHORTEST
    if (near && i + 3 < points.length) continue
    at.push(px, py)
    lastX = px
    lastY = py
    left = Math.min(left, px)
    right = Math.max(right, px)
    top = Math.min(top, py)
    bottom = Math.max(bottom, py)
  }
  const seen = right >= 0 && bottom >= 0 && left <= width && top <= height
  return seen && at.length > 2 ? at : null
}

function strokeLines(context: Context, lines: Line[], { theme, dpr }: PanelView): void {
  context.lineJoin = 'round'
  for (const main of [false, true]) {
    context.beginPath()
    for (const line of lines) {
      if (line.main === main) trail(context, line.at)
    }
    context.strokeStyle = COLOURS[theme][main ? 'main' : 'line']
    context.lineWidth = (main ? 1.35 : 0.9) * dpr
    context.stroke()
  }
  writeHeights(
    context,
    lines.filter(({ main }) => main),
    theme,
    dpr,
  )
}

function trail(context: Context, at: number[]): void {
  context.moveTo(at[0] ?? 0, at[1] ?? 0)
  for (let i = 2; i < at.length; i += 2) context.lineTo(at[i] ?? 0, at[i + 1] ?? 0)
}

/** Along the main lines, where they run straight enough, never two close together. */
function writeHeights(
  context: Context,
  lines: Line[],
  theme: PanelView['theme'],
  dpr: number,
): void {
  const size = 10.5 * dpr
  context.font = `600 ${size}px system-ui, sans-serif`
  context.textAlign = 'center'
  context.textBaseline = 'middle'
  context.lineWidth = 3.5 * dpr
  context.strokeStyle = HALO[theme]
  context.fillStyle = COLOURS[theme].text
  const taken: [number, number][] = []
  for (const { at, height } of lines) {
    const text = `${Number(height.toPrecision(6))} m`
    const room = context.measureText(text).width + 10 * dpr
    for (const place of places(at, room, LABEL_EVERY * dpr)) {
      if (taken.some(([x, y]) => Math.hypot(x - place.x, y - place.y) < 80 * dpr)) continue
      taken.push([place.x, place.y])
      context.setTransform(
        Math.cos(place.turn),
        Math.sin(place.turn),
        -Math.sin(place.turn),
        Math.cos(place.turn),
        place.x,
        place.y,
      )
      context.strokeText(text, 0, 0)
      context.fillText(text, 0, 0)
    }
  }
  context.resetTransform()
}

interface Place {
  x: number
  y: number
  /** Radians; never upside down. */
  turn: number
}

function places(at: number[], room: number, every: number): Place[] {
  const found: Place[] = []
  let wait = every / 3
  let begin = 0
  let length = 0
  for (let i = 2; i < at.length; i += 2) {
    length += Math.hypot((at[i] ?? 0) - (at[i - 2] ?? 0), (at[i + 1] ?? 0) - (at[i - 1] ?? 0))
    if (wait > 0) {
      wait -= length
      length = 0
      begin = i
      continue
    }
    if (length < room) continue
    const place = between(at, begin, i, length)
    if (place) found.push(place)
    wait = place ? every : room / 2
    length = 0
    begin = i
  }
  return found
}

/** The middle of a stretch of line, if it is straight enough to write on. */
function between(at: number[], from: number, to: number, length: number): Place | null {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = [at[from], at[from + 1], at[to], at[to + 1]]
  if (Math.hypot(x1 - x0, y1 - y0) < 0.93 * length) return null
  const turn = Math.atan2(y1 - y0, x1 - x0)
  const upright = Math.abs(turn) > Math.PI / 2 ? turn + Math.PI : turn
  const middle = 2 * Math.round((from + to) / 4)
  return { x: at[middle] ?? x0, y: at[middle + 1] ?? y0, turn: upright }
}
