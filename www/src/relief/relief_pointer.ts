/**
 * Mouse, pen and touch over a terrain in three dimensions: dragging turns it, with the right or middle button, Shift or the view's tool
 * shifts it, Ctrl and the wheel or pinching zoom. Start and goals can be taken up with any tool; a click with their tools puts them down.
 */
import type { ReadonlySignal, Signal } from '@preact/signals'
import { t } from '../i18n'
import type { Cell } from '../model/cell'
import { type Brush, brushFor, newGesture, stroke } from '../stage/brush'
import { listenToPointers, type PointerHandlers, wheelZooms } from '../stage/listen'
import type { CanvasSize, Cursor } from '../stage/panel_view'
import { activeGoal, applyEdit, notify, refuseMoreGoals, scenario, tool } from '../state'
import { showRelief } from '../state/relief'
import { eye, orbit, resetEye, shiftEye, zoomEye } from './eye'
import { endsOf, markSize } from './marks_overlay'
import type { ReliefView } from './relief_view'

type Point = [number, number]

interface Held {
  at: Point
  /** Where it was put down, for telling a click from a drag. */
  from: Point
  shifting: boolean
  moved: boolean
}

const ZOOM_PER_PIXEL = 1.0016
/** A whole turn takes a drag over so much of the stage's width. */
const TURN_PER_WIDTH = 3.4
/** CSS pixels. */
const CLICK_SLOP = 5
const FINGER = 16

export class ReliefPointer {
  private readonly held = new Map<number, Held>()
  private drawing: { pointerId: number; brush: Brush; gesture: number; last: Cell } | null = null
  private readonly listening = new AbortController()

  constructor(
    private readonly element: HTMLElement,
    private readonly view: ReliefView,
    private readonly size: ReadonlySignal<CanvasSize>,
    private readonly cursor: Signal<Cursor | null>,
    private readonly inspect: (cell: Cell) => void,
  ) {
    const handlers: PointerHandlers = {
      pointerdown: (event) => this.down(event),
      pointermove: (event) => this.move(event),
      pointerup: (event) => this.up(event),
      pointercancel: (event) => this.cancel(event),
      pointerleave: () => this.leave(),
      dblclick: () => tool.peek() === 'pan' && resetEye(),
      contextmenu: (event) => event.preventDefault(),
      wheel: (event) => this.wheel(event),
    }
    listenToPointers(element, handlers, this.listening.signal)
  }

  release(): void {
    this.listening.abort()
  }

  private down(event: PointerEvent): void {
    const at = this.point(event)
    this.element.setPointerCapture(event.pointerId)
    const takes = event.button === 0 && this.held.size === 0 && tool.peek() !== 'inspect'
    const mark = takes ? this.markAt(at, event) : null
    if (mark) {
      if (mark.brush.kind === 'goal') activeGoal.value = mark.brush.index
      this.drawing = { pointerId: event.pointerId, gesture: newGesture(), last: mark.at, ...mark }
      return
    }
    const shifting = event.button !== 0 || event.shiftKey || tool.peek() === 'pan'
    this.held.set(event.pointerId, { at, from: at, shifting, moved: false })
  }

  private move(event: PointerEvent): void {
    const at = this.point(event)
    if (this.drawing?.pointerId === event.pointerId) {
      this.drag(at)
      return
    }
    const held = this.held.get(event.pointerId)
    if (!held) {
      this.hover(at)
      return
    }
    const slop = CLICK_SLOP * this.size.peek().dpr
    held.moved ||= this.held.size > 1 || distance(at, held.from) > slop
    if (held.moved) this.turn(held, at)
    held.at = at
  }

  private turn(held: Held, at: Point): void {
    const { width, height } = this.size.peek()
    const [dx, dy] = [(at[0] - held.at[0]) / width, (at[1] - held.at[1]) / width]
    const other = [...this.held.values()].find((each) => each !== held)
    if (other) {
      const before = distance(held.at, other.at)
      if (before > 0) zoomEye(distance(at, other.at) / before)
      this.shift(dx / 2, dy / 2)
    } else if (held.shifting) this.shift(dx, dy)
    else orbit(-dx * TURN_PER_WIDTH, (dy * width * 2.4) / height)
  }

  private shift(dx: number, dy: number): void {
    const spec = scenario.peek()?.spec
    if (spec) shiftEye((-1.5 * dx) / this.zoom, (2 * dy) / this.zoom, spec.width, spec.height)
  }

  private get zoom(): number {
    return this.view.zoom
  }

  private up(event: PointerEvent): void {
    const held = this.held.get(event.pointerId)
    this.cancel(event)
    if (event.pointerType === 'touch') this.cursor.value = null
    if (held && !held.moved && event.button === 0) this.click(this.point(event))
  }

  private cancel(event: PointerEvent): void {
    this.held.delete(event.pointerId)
    if (this.drawing?.pointerId === event.pointerId) this.drawing = null
  }

  /** Walls are drawn on the flat map, where every cell can be met; here a click is for start and goals. */
  private click(at: Point): void {
    const now = scenario.peek()
    const cell = this.view.cellAt(at)
    if (!now || !cell || tool.peek() === 'pan') return
    if (tool.peek() === 'inspect') {
      this.inspect(cell)
      return
    }
    if (!placesEnds()) {
      notify('info', t('relief.wallsFlat'), {
        action: { label: t('relief.flatHint'), run: () => void showRelief(false) },
      })
      return
    }
    const brush = brushFor(tool.peek(), now, cell, activeGoal.peek())
    if (brush === null) refuseMoreGoals()
    else if (brush.kind !== 'wall') {
      if (brush.kind === 'goal') activeGoal.value = brush.index
      applyEdit(stroke(brush, cell, cell), newGesture())
    }
  }

  private drag(at: Point): void {
    const cell = this.view.cellAt(at)
    if (!this.drawing || !cell) return
    applyEdit(stroke(this.drawing.brush, this.drawing.last, cell), this.drawing.gesture)
    this.drawing.last = cell
    this.cursor.value = { cell, byKeys: false }
  }

  private hover(at: Point): void {
    const cell = this.view.cellAt(at)
    const before = this.cursor.peek()
    if (
      cell &&
      before &&
      !before.byKeys &&
      before.cell[0] === cell[0] &&
      before.cell[1] === cell[1]
    )
      return
    if (cell || before) this.cursor.value = cell && { cell, byKeys: false }
  }

  private leave(): void {
    if (this.cursor.peek()?.byKeys === false) this.cursor.value = null
  }

  private wheel(event: WheelEvent): void {
    if (!wheelZooms(event, eye.peek().zoom)) return
    event.preventDefault()
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 * event.deltaY : event.deltaY
    zoomEye(ZOOM_PER_PIXEL ** -pixels)
  }

  /** The mark under a point, nearest first. */
  private markAt(at: Point, { pointerType }: PointerEvent): { brush: Brush; at: Cell } | null {
    const scene = this.view.scene()
    if (!scene) return null
    const { spec } = scene.scenario
    const reach =
      Math.max(markSize(spec.goals.length > 1) + 2, pointerType === 'touch' ? FINGER : 0) *
      this.size.peek().dpr
    const found = endsOf(scene).flatMap(({ top }, i) => {
      const place = scene.camera.project(top)
      const away = place ? distance(place, at) : Number.POSITIVE_INFINITY
      const goal = spec.goals[i - 1]
      const brush: Brush = goal ? { kind: 'goal', index: i - 1 } : { kind: 'start' }
      return away <= reach ? [{ away, brush, at: goal?.at ?? spec.start }] : []
    })
    found.sort((a, b) => a.away - b.away)
    return found[0] ?? null
  }

  private point(event: MouseEvent): Point {
    const box = this.element.getBoundingClientRect()
    const { dpr } = this.size.peek()
    return [(event.clientX - box.left) * dpr, (event.clientY - box.top) * dpr]
  }
}

/** Whether the tool is one for start and goals. */
export const placesEnds = () => ['start', 'goal', 'add-goal'].includes(tool.peek())

function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1])
}
