/** Keys on a focused stage: arrows move the cell cursor, Enter or x uses the tool there. Every other key is the page's. */
import type { ReadonlySignal, Signal } from '@preact/signals'
import { t } from '../i18n'
import { type Cell, goalOf, isBlocked, sameCell } from '../maps/edit'
import type { Scenario } from '../session'
import { announce, applyEdit, scenario, tool } from '../state'
import { brushFor, newGesture, stroke } from './brush'
import type { Cursor } from './look'
import { fitView, panBy, reveal, type Size, viewpoint, zoomBy } from './view'

const ARROWS: Record<string, Cell> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
}
/** Ctrl with an arrow crosses the map in strides. */
const STRIDE = 10

export function keyboardHandler(
  size: ReadonlySignal<Size>,
  cursor: Signal<Cursor | null>,
): (event: KeyboardEvent) => void {
  return (event) => {
    const now = scenario.peek()
    if (now === null || event.altKey || event.metaKey) return
    if (handle(event, now, size.peek(), cursor)) {
      event.preventDefault()
      event.stopPropagation()
    }
  }
}

/** True when the key was the stage's. */
function handle(
  event: KeyboardEvent,
  now: Scenario,
  size: Size,
  cursor: Signal<Cursor | null>,
): boolean {
  const arrow = ARROWS[event.key]
  if (arrow && !event.shiftKey) {
    const steps = event.ctrlKey ? STRIDE : 1
    if (tool.peek() === 'pan') pan(arrow, now, size)
    else moveCursor([arrow[0] * steps, arrow[1] * steps], now, size, cursor)
    return true
  }
  if (event.ctrlKey) return false
  switch (event.key) {
    case 'Enter':
    case 'x':
      use(cursor.peek()?.cell ?? now.spec.start, now)
      return true
    case '+':
    case '=':
      zoomBy(1.25)
      return true
    case '-':
      zoomBy(0.8)
      return true
    case '0':
      fitView()
      return true
    default:
      return false
  }
}

/** The first press brings the cursor to where the pointer was, or to the start. */
function moveCursor(
  [dx, dy]: Cell,
  now: Scenario,
  size: Size,
  cursor: Signal<Cursor | null>,
): void {
  const { width, height, start } = now.spec
  const from = cursor.peek()?.cell
  const cell: Cell = from ? [clamp(from[0] + dx, width), clamp(from[1] + dy, height)] : start
  cursor.value = { cell, byKeys: true }
  viewpoint.value = reveal(viewpoint.peek(), cell, size, now.spec)
  announce(describe(cell, now))
}

function pan([dx, dy]: Cell, now: Scenario, size: Size): void {
  const step = Math.round(0.1 * Math.min(size.width, size.height))
  viewpoint.value = panBy(viewpoint.peek(), -dx * step, -dy * step, size, now.spec)
}

/** On start or goal the keys have nothing to drag, so the wall tools leave them alone. */
function use(cell: Cell, now: Scenario): void {
  const brush = brushFor(tool.peek(), now, cell)
  if (brush === null) return
  applyEdit(stroke(brush, cell, cell), newGesture())
  announce(describe(cell, scenario.peek() ?? now))
}

function describe(cell: Cell, now: Scenario): string {
  return t('stage.cell', { x: cell[0], y: cell[1], what: t(`stage.${contentOf(cell, now)}`) })
}

function contentOf(cell: Cell, now: Scenario): 'start' | 'goal' | 'wall' | 'free' {
  if (sameCell(cell, now.spec.start)) return 'start'
  if (sameCell(cell, goalOf(now))) return 'goal'
  return isBlocked(now, cell) ? 'wall' : 'free'
}

function clamp(value: number, size: number): number {
  return Math.min(size - 1, Math.max(0, value))
}
