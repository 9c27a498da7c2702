/** The difference's canvas on the page's own thread: seen from where all maps are seen, shifted and zoomed like them, never edited. */
import type { ReadonlySignal, Signal } from '@preact/signals'
import { drawMarksAt } from '../drawing/draw_marks'
import { markRadius } from '../drawing/mark_radius'
import type { Cell } from '../model/cell'
import { isInside, sameCell } from '../model/edit'
import type { Scenario } from '../model/session'
import {
  fitView,
  type Placement,
  type Point,
  reveal,
  toMap,
  viewpoint,
  zoomAt,
  zoomBy,
} from '../model/viewpoint'
import { ARROWS, STRIDE, shiftCursor } from '../stage/keyboard'
import { PanZoomGesture } from '../stage/pan_zoom_gesture'
import { type CanvasSize, type Cursor, place } from '../stage/panel_view'
import { scenario, theme } from '../state'
import { type Trails, trails } from './difference'
import { paintDifference } from './difference_map'

/** All that a drawing depends on. */
interface Picture {
  size: CanvasSize
  placement: Placement
  scenario: Scenario | null
  trails: Trails | null
  theme: 'light' | 'dark'
  cursor: Cursor | null
}

const ZOOM_PER_PIXEL = 1.0016

export class DifferenceStage {
  private readonly canvas = document.createElement('canvas')
  private readonly hold = new PanZoomGesture()
  private readonly listening = new AbortController()
  private raster: OffscreenCanvas | null = null
  /** What the raster was painted from. */
  private painted: unknown[] = []

  constructor(
    private readonly element: HTMLElement,
    private readonly size: ReadonlySignal<CanvasSize>,
    private readonly cursor: Signal<Cursor | null>,
  ) {
    this.canvas.setAttribute('aria-hidden', 'true')
    element.append(this.canvas)
    const { signal } = this.listening
    element.addEventListener('pointerdown', (event) => this.down(event), { signal })
    element.addEventListener('pointermove', (event) => this.move(event), { signal })
    element.addEventListener('pointerup', (event) => this.hold.drop(event.pointerId), { signal })
    element.addEventListener('pointercancel', (event) => this.hold.drop(event.pointerId), {
      signal,
    })
    element.addEventListener('pointerleave', () => this.leave(), { signal })
    element.addEventListener('dblclick', fitView, { signal })
    element.addEventListener('wheel', (event) => this.wheel(event), { signal, passive: false })
    element.addEventListener('keydown', (event) => this.key(event), { signal })
  }

  release(): void {
    this.listening.abort()
    this.canvas.remove()
  }

  /** Reads every signal that the picture depends on. */
  picture(): Picture {
    return {
      size: this.size.value,
      placement: place(this.size.value),
      scenario: scenario.value,
      trails: trails.value,
      theme: theme.value,
      cursor: this.cursor.value,
    }
  }

  draw(picture: Picture): void {
    const { canvas } = this
    const { size, placement, scenario: map, cursor } = picture
    if (canvas.width !== size.width) canvas.width = size.width
    if (canvas.height !== size.height) canvas.height = size.height
    const context = canvas.getContext('2d')
    if (!context) return
    context.clearRect(0, 0, size.width, size.height)
    if (!map) return
    const { scale, originX, originY } = placement
    const raster = this.paint(picture, map)
    context.imageSmoothingEnabled = scale < 1
    context.drawImage(raster, originX, originY, raster.width * scale, raster.height * scale)
    drawEnds(context, picture, map)
    if (cursor) drawCursor(context, picture, cursor)
  }

  private paint({ trails: now, theme: colours }: Picture, map: Scenario): OffscreenCanvas {
    const { width, height } = map.spec
    if (this.raster?.width !== width || this.raster.height !== height)
      this.raster = new OffscreenCanvas(width, height)
    const fits = now && now.a.length === width * height ? now : null
    const sources = [this.raster, map.cells, fits, colours]
    if (sources.some((source, i) => source !== this.painted[i])) {
      paintDifference(this.raster, map, fits, colours)
      this.painted = sources
    }
    return this.raster
  }

  private down(event: PointerEvent): void {
    if (event.button > 1) return
    this.element.setPointerCapture(event.pointerId)
    this.hover(this.point(event))
    this.hold.take(event.pointerId, this.point(event))
  }

  private move(event: PointerEvent): void {
    const at = this.point(event)
    if (this.hold.has(event.pointerId)) this.hold.move(event.pointerId, at, this.size.peek())
    else this.hover(at)
  }

  private hover(at: Point): void {
    const now = scenario.peek()
    const [x, y] = toMap(place(this.size.peek()), at)
    const cell: Cell = [Math.floor(x), Math.floor(y)]
    const before = this.cursor.peek()
    if (before && !before.byKeys && sameCell(before.cell, cell)) return
    this.cursor.value = now && isInside(now, cell) ? { cell, byKeys: false } : null
  }

  private leave(): void {
    if (this.cursor.peek()?.byKeys === false) this.cursor.value = null
  }

  private wheel(event: WheelEvent): void {
    const map = scenario.peek()?.spec
    if (!map) return
    event.preventDefault()
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 * event.deltaY : event.deltaY
    const factor = ZOOM_PER_PIXEL ** -pixels
    viewpoint.value = zoomAt(viewpoint.peek(), factor, this.point(event), this.size.peek(), map)
  }

  private key(event: KeyboardEvent): void {
    const now = scenario.peek()
    const arrow = ARROWS[event.key]
    if (!now || event.altKey || event.metaKey || event.shiftKey) return
    if (arrow) {
      const steps = event.ctrlKey ? STRIDE : 1
      const cell = shiftCursor([arrow[0] * steps, arrow[1] * steps], now, this.cursor)
      viewpoint.value = reveal(viewpoint.peek(), cell, this.size.peek(), now.spec)
    } else if (event.key === '+' || event.key === '=') zoomBy(1.25)
    else if (event.key === '-') zoomBy(0.8)
    else return
    event.preventDefault()
    event.stopPropagation()
  }

  private point(event: MouseEvent): Point {
    const box = this.element.getBoundingClientRect()
    const { dpr } = this.size.peek()
    return [(event.clientX - box.left) * dpr, (event.clientY - box.top) * dpr]
  }
}

function centre({ placement: { scale, originX, originY } }: Picture, [x, y]: Cell): Point {
  return [originX + (x + 0.5) * scale, originY + (y + 0.5) * scale]
}

function drawEnds(context: CanvasRenderingContext2D, picture: Picture, { spec }: Scenario): void {
  const { size, placement, theme: colours } = picture
  const radius = markRadius({ scale: placement.scale, dpr: size.dpr }, spec.goals.length > 1)
  const look = {
    theme: colours,
    dpr: size.dpr,
    width: size.width,
    height: size.height,
    goalNames: spec.goals.map(({ name }) => name),
  }
  const at = {
    start: centre(picture, spec.start),
    goals: spec.goals.map((goal) => centre(picture, goal.at)),
  }
  drawMarksAt(context, look, at, radius, [])
}

function drawCursor(context: CanvasRenderingContext2D, picture: Picture, { cell, byKeys }: Cursor) {
  const { dpr } = picture.size
  const side = Math.max(picture.placement.scale, (byKeys ? 9 : 5) * dpr)
  const [x, y] = centre(picture, cell)
  for (const [colour, width] of [
    [picture.theme === 'dark' ? '#14161c' : '#ffffff', byKeys ? 5 : 3],
    [picture.theme === 'dark' ? '#fff3dc' : '#1c1712', byKeys ? 2 : 1],
  ] as const) {
    context.strokeStyle = colour
    context.lineWidth = width * dpr
    context.strokeRect(x - side / 2, y - side / 2, side, side)
  }
}
