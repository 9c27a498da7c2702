/**
 * Mouse, pen and touch on one stage. One pointer draws or drags; the middle button, the pan tool or two fingers move the map;
 * Ctrl and the wheel, or pinching, zoom, and the wheel alone once the map is magnified: else it scrolls. Moves are gathered and
 * applied once a frame, joined by lines so that fast drags leave no holes. While one draws nothing moves: the page holds still
 * (`beginPress`), and cells are read from where the map lay at the press.
 */
import type { ReadonlySignal, Signal } from '@preact/signals'
import type { Cell } from '../model/cell'
import { isInside, sameCell } from '../model/edit'
import type { Scenario } from '../model/session'
import type { HeldKeys, Stroke } from '../model/stroke'
import { fitView, type Placement, type Point, toMap, viewpoint, zoomAt } from '../model/viewpoint'
import { activeGoal, beginPress, editor, endPress, refuseMoreGoals, scenario, tool } from '../state'
import { mapIsFixed } from '../state/embedding'
import { type Brush, brushFor } from './brush'
import { brushStroke } from './brush_stroke'
import { listenToPointers, type PointerHandlers, wheelZooms } from './listen'
import { type MarkerUnder, markerUnder } from './marker_under'
import { PanZoomGesture } from './pan_zoom_gesture'
import { type CanvasSize, type Cursor, place } from './panel_view'

/** Where the element and its map lie on the screen. */
interface Frame {
  left: number
  top: number
  dpr: number
  placement: Placement
}

interface Drawing {
  pointerId: number
  stroke: Stroke
  /** As it was at the press. */
  frame: Frame
  pending: [Cell, HeldKeys][]
  /** Where the pointer is. */
  last: Point
  /** Nothing is drawn before: a second finger may yet turn this into a pinch. */
  notBefore: number
}

const ZOOM_PER_PIXEL = 1.0016
const PINCH_GRACE_MS = 90
/** A press that has gone no further is a click; CSS pixels. */
const CLICK_SLOP = 5
/** Fingers miss what is small; CSS pixels. */
const FINGER = 20

export class PointerInput {
  private drawing: Drawing | null = null
  private readonly hold = new PanZoomGesture()
  /** A press with the tool that looks into cells. */
  private looking: { pointerId: number; at: Point } | null = null
  private requested = 0
  private readonly listening = new AbortController()

  constructor(
    private readonly element: HTMLElement,
    private readonly size: ReadonlySignal<CanvasSize>,
    private readonly cursor: Signal<Cursor | null>,
    private readonly inspect: (cell: Cell) => void,
  ) {
    const end = (event: PointerEvent) => this.up(event)
    const handlers: PointerHandlers = {
      pointerdown: (event) => this.down(event),
      pointermove: (event) => this.move(event),
      pointerup: end,
      pointercancel: end,
      pointerleave: () => this.leave(),
      dblclick: () => this.doubleClick(),
      wheel: (event) => this.wheel(event),
    }
    listenToPointers(element, handlers, this.listening.signal)
  }

  release(): void {
    this.listening.abort()
    if (this.drawing !== null) endPress()
    cancelAnimationFrame(this.requested)
  }

  private down(event: PointerEvent): void {
    const at = this.point(event)
    this.element.setPointerCapture(event.pointerId)
    const end = this.endAt(event, at)
    const looks = event.button === 0 && tool.peek() === 'inspect'
    const pans = event.button === 0 && tool.peek() === 'pan' && end === null
    this.looking = null
    if (this.drawing !== null || this.hold.active) {
      this.joinPinch(event.pointerId, at)
    } else if (event.button === 1 || pans || looks) {
      event.preventDefault()
      // The click gives the map the focus all the same: keys are for this map from now on.
      if (looks) this.element.focus()
      this.hold.take(event.pointerId, at)
      if (looks) this.looking = { pointerId: event.pointerId, at }
    } else if (event.button === 0) this.begin(event, at, end)
  }

  /** A press that has not shifted the map looks into its cell. */
  private look(event: PointerEvent): void {
    const { looking } = this
    if (looking?.pointerId !== event.pointerId) return
    this.looking = null
    const [x, y] = this.point(event)
    const slop = CLICK_SLOP * this.size.peek().dpr
    if (Math.hypot(x - looking.at[0], y - looking.at[1]) > slop) return
    const now = scenario.peek()
    const cell = this.cell(looking.at)
    if (now && isInside(now, cell)) this.inspect(cell)
  }

  private begin(event: PointerEvent, at: Point, end: MarkerUnder | null): void {
    const now = scenario.peek()
    const cell = end?.at ?? this.cell(at)
    if (now === null || !isInside(now, cell)) return
    const stroke = end ? this.take(end.brush, cell) : this.strokeFor(event, at, cell, now)
    if (stroke === null) {
      refuseMoreGoals()
      return
    }
    const notBefore = event.pointerType === 'touch' ? performance.now() + PINCH_GRACE_MS : 0
    const { pointerId } = event
    this.drawing = {
      pointerId,
      stroke,
      frame: this.frame(),
      pending: [[cell, event]],
      last: at,
      notBefore,
    }
    beginPress()
    this.request()
  }

  private strokeFor(event: PointerEvent, at: Point, cell: Cell, now: Scenario): Stroke | null {
    const { placement, dpr } = this.frame()
    const { shiftKey, ctrlKey, altKey } = event
    const slack = ((event.pointerType === 'touch' ? FINGER : CLICK_SLOP) * dpr) / placement.scale
    const press = { cell, at: toMap(placement, at), slack, shiftKey, ctrlKey, altKey }
    const further = editor.peek()?.begin(press)
    if (further) return further
    const brush = brushFor(tool.peek(), now, cell, activeGoal.peek())
    return brush && this.take(brush, cell)
  }

  private take(brush: Brush, cell: Cell): Stroke {
    if (brush.kind === 'goal') activeGoal.value = brush.index
    return brushStroke(brush, cell)
  }

  private move(event: PointerEvent): void {
    const at = this.point(event)
    if (this.hold.has(event.pointerId)) {
      this.hold.move(event.pointerId, at, this.size.peek())
      return
    }
    this.hover(at)
    if (this.drawing?.pointerId !== event.pointerId) return
    this.drawing.last = at
    this.drawing.pending.push([this.cell(at), event])
    this.request()
  }

  private up(event: PointerEvent): void {
    this.hold.drop(event.pointerId)
    if (event.type === 'pointerup') this.look(event)
    if (event.pointerType === 'touch') this.cursor.value = null
    if (this.drawing?.pointerId !== event.pointerId) return
    this.draw()
    const { stroke } = this.drawing
    this.drawing = null
    if (event.type === 'pointerup') stroke.end?.()
    else stroke.drop?.()
    endPress()
  }

  /** A second finger turns a stroke into a pinch; what has not been drawn yet is dropped. */
  private joinPinch(pointerId: number, at: Point): void {
    if (this.drawing !== null) {
      const { pointerId: first, stroke, last } = this.drawing
      this.hold.take(first, last)
      this.drawing = null
      stroke.drop?.()
      endPress()
    }
    this.hold.take(pointerId, at)
  }

  private wheel(event: WheelEvent): void {
    const map = scenario.peek()?.spec
    if (map === undefined || !wheelZooms(event, viewpoint.peek().zoom)) return
    event.preventDefault()
    if (this.drawing !== null) return
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 * event.deltaY : event.deltaY
    const factor = ZOOM_PER_PIXEL ** -pixels
    viewpoint.value = zoomAt(viewpoint.peek(), factor, this.point(event), this.size.peek(), map)
  }

  /** While drawing, two quick clicks are two cells. */
  private doubleClick(): void {
    if (tool.peek() === 'pan') fitView()
  }

  private hover(at: Point): void {
    const now = scenario.peek()
    const cell = this.cell(at)
    const before = this.cursor.peek()
    if (before !== null && !before.byKeys && sameCell(before.cell, cell)) return
    this.cursor.value = now && isInside(now, cell) ? { cell, byKeys: false } : null
  }

  private leave(): void {
    if (this.cursor.peek()?.byKeys === false) this.cursor.value = null
  }

  private request(): void {
    if (this.requested !== 0) return
    this.requested = requestAnimationFrame(() => {
      this.requested = 0
      if (performance.now() < (this.drawing?.notBefore ?? 0)) this.request()
      else this.draw()
    })
  }

  private draw(): void {
    if (this.drawing === null) return
    const { stroke, pending } = this.drawing
    for (const [cell, keys] of pending) stroke.go(cell, keys)
    pending.length = 0
  }

  private endAt(event: PointerEvent, at: Point): MarkerUnder | null {
    const now = scenario.peek()
    if (now === null || mapIsFixed.peek()) return null
    const { placement, dpr } = this.frame()
    return markerUnder(now, at, placement, dpr, event.pointerType === 'touch')
  }

  private frame(): Frame {
    if (this.drawing !== null) return this.drawing.frame
    const { left, top } = this.element.getBoundingClientRect()
    const size = this.size.peek()
    return { left, top, dpr: size.dpr, placement: place(size) }
  }

  private cell(at: Point): Cell {
    const [x, y] = toMap(this.frame().placement, at)
    return [Math.floor(x), Math.floor(y)]
  }

  private point(event: MouseEvent): Point {
    const { left, top, dpr } = this.frame()
    return [(event.clientX - left) * dpr, (event.clientY - top) * dpr]
  }
}
