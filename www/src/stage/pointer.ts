/**
 * Mouse, pen and touch on one stage. One pointer draws or drags; the middle button, the pan tool or two fingers move the map;
 * Ctrl and the wheel, or pinching, zoom, and the wheel alone once the map is magnified: else it scrolls. Moves are gathered and applied once a frame, joined by lines so that fast drags leave no holes.
 */
import type { ReadonlySignal, Signal } from '@preact/signals'
import type { Cell } from '../model/cell'
import { isInside, sameCell } from '../model/edit'
import { fitView, type Placement, type Point, toMap, viewpoint, zoomAt } from '../model/viewpoint'
import { activeGoal, applyEdit, refuseMoreGoals, scenario, tool } from '../state'
import { type Brush, brushFor, newGesture, stroke } from './brush'
import { listenToPointers, type PointerHandlers, wheelZooms } from './listen'
import { type MarkerUnder, markerUnder } from './marker_under'
import { PanZoomGesture } from './pan_zoom_gesture'
import { type CanvasSize, type Cursor, place } from './panel_view'

interface Drawing {
  pointerId: number
  brush: Brush
  gesture: number
  last: Cell
  pending: Cell[]
  /** Nothing is drawn before: a second finger may yet turn this into a pinch. */
  notBefore: number
}

const ZOOM_PER_PIXEL = 1.0016
const PINCH_GRACE_MS = 90
/** A press that has gone no further is a click; CSS pixels. */
const CLICK_SLOP = 5

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
    const brush = end?.brush ?? brushFor(tool.peek(), now, cell, activeGoal.peek())
    if (brush === null) {
      refuseMoreGoals()
      return
    }
    if (brush.kind === 'goal') activeGoal.value = brush.index
    const notBefore = event.pointerType === 'touch' ? performance.now() + PINCH_GRACE_MS : 0
    this.drawing = {
      pointerId: event.pointerId,
      brush,
      gesture: newGesture(),
      last: cell,
      pending: [cell],
      notBefore,
    }
    this.request()
  }

  private move(event: PointerEvent): void {
    const at = this.point(event)
    if (this.hold.has(event.pointerId)) {
      this.hold.move(event.pointerId, at, this.size.peek())
      return
    }
    this.hover(at)
    if (this.drawing?.pointerId !== event.pointerId) return
    this.drawing.pending.push(this.cell(at))
    this.request()
  }

  private up(event: PointerEvent): void {
    this.hold.drop(event.pointerId)
    if (event.type === 'pointerup') this.look(event)
    if (event.pointerType === 'touch') this.cursor.value = null
    if (this.drawing?.pointerId !== event.pointerId) return
    this.draw()
    this.drawing = null
  }

  /** A second finger turns a stroke into a pinch; what has not been drawn yet is dropped. */
  private joinPinch(pointerId: number, at: Point): void {
    if (this.drawing !== null) {
      this.hold.take(
        this.drawing.pointerId,
        this.centreOf(this.drawing.pending.at(-1) ?? this.drawing.last),
      )
      this.drawing = null
    }
    this.hold.take(pointerId, at)
  }

  private wheel(event: WheelEvent): void {
    const map = scenario.peek()?.spec
    if (map === undefined || !wheelZooms(event, viewpoint.peek().zoom)) return
    event.preventDefault()
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
    const { brush, gesture, pending } = this.drawing
    for (const cell of pending) {
      applyEdit(stroke(brush, this.drawing.last, cell), gesture)
      this.drawing.last = cell
    }
    pending.length = 0
  }

  private endAt(event: PointerEvent, at: Point): MarkerUnder | null {
    const now = scenario.peek()
    if (now === null) return null
    return markerUnder(
      now,
      at,
      this.placement(),
      this.size.peek().dpr,
      event.pointerType === 'touch',
    )
  }

  private placement(): Placement {
    return place(this.size.peek())
  }

  private cell(at: Point): Cell {
    const [x, y] = toMap(this.placement(), at)
    return [Math.floor(x), Math.floor(y)]
  }

  private centreOf([x, y]: Cell): Point {
    const { scale, originX, originY } = this.placement()
    return [originX + (x + 0.5) * scale, originY + (y + 0.5) * scale]
  }

  private point(event: MouseEvent): Point {
    const box = this.element.getBoundingClientRect()
    const { dpr } = this.size.peek()
    return [(event.clientX - box.left) * dpr, (event.clientY - box.top) * dpr]
  }
}
