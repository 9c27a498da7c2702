/**
 * Keys on a focused stage: arrows move the cell cursor, Enter or x uses the tool there, Delete removes a goal, Page Up and Page Down
 * change the level of an end of paths by slices. Every other key is the page's.
 */
import type { ReadonlySignal, Signal } from '@preact/signals'
import { t } from '../i18n'
import type { Cell } from '../model/cell'
import { isBlocked, sameCell } from '../model/edit'
import { goalIndexAt, goalName } from '../model/goals'
import type { Scenario } from '../model/session'
import { type CanvasSize, fitView, panBy, reveal, viewpoint, zoomBy } from '../model/viewpoint'
import {
  activeGoal,
  announce,
  applyEdit,
  changeLevel,
  editor,
  refuseMoreGoals,
  scenario,
  tool,
} from '../state'
import { mapIsFixed } from '../state/embedding'
import { placeShown } from '../words/lengths'
import { brushFor, newGesture, stroke } from './brush'
import type { Cursor } from './panel_view'

export const ARROWS: Record<string, Cell> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
}
/** Ctrl with an arrow crosses the map in strides. */
export const STRIDE = 10

export function keyboardHandler(
  size: ReadonlySignal<CanvasSize>,
  cursor: Signal<Cursor | null>,
  inspect: (cell: Cell) => void,
): (event: KeyboardEvent) => void {
  return (event) => {
    const now = scenario.peek()
    if (now === null) return
    if (editor.peek()?.key(event, cursor)) {
      event.preventDefault()
      event.stopPropagation()
      return
    }
    if (event.altKey || event.metaKey) return
    if (handleInspection(event, now, cursor, inspect) || handle(event, now, size.peek(), cursor)) {
      event.preventDefault()
      event.stopPropagation()
    }
  }
}

/** With the tool that looks into cells, Enter and x do. True when the key was one of them. */
export function handleInspection(
  { key }: KeyboardEvent,
  now: Scenario,
  cursor: Signal<Cursor | null>,
  inspect: (cell: Cell) => void,
): boolean {
  if (tool.peek() !== 'inspect' || (key !== 'Enter' && key !== 'x')) return false
  inspect(cursor.peek()?.cell ?? now.spec.start)
  return true
}

/** True when the stage has handled the key. */
function handle(
  event: KeyboardEvent,
  now: Scenario,
  size: CanvasSize,
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
  if (handleAtCursor(event, now, cursor)) return true
  switch (event.key) {
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

/** What keys do at the cell cursor, whichever way the map is looked at. True when the key was one of them. */
export function handleAtCursor(
  { key }: KeyboardEvent,
  now: Scenario,
  cursor: Signal<Cursor | null>,
): boolean {
  if (mapIsFixed.peek()) return false
  const cell = cursor.peek()?.cell ?? null
  switch (key) {
    case 'Enter':
    case 'x':
      use(cell ?? now.spec.start, now)
      return true
    case 'Delete':
    case 'Backspace':
      return remove(cell, now)
    case 'PageUp':
    case 'PageDown':
      return lift(cell, now, key === 'PageUp' ? 1 : -1)
    default:
      return false
  }
}

function moveCursor(
  by: Cell,
  now: Scenario,
  size: CanvasSize,
  cursor: Signal<Cursor | null>,
): void {
  const cell = shiftCursor(by, now, cursor)
  viewpoint.value = reveal(viewpoint.peek(), cell, size, now.spec)
}

/** The first press brings the cursor to where the pointer was, or to the start. */
export function shiftCursor([dx, dy]: Cell, now: Scenario, cursor: Signal<Cursor | null>): Cell {
  const { width, height, start } = now.spec
  const from = cursor.peek()?.cell
  const cell: Cell = from ? [clamp(from[0] + dx, width), clamp(from[1] + dy, height)] : start
  cursor.value = { cell, byKeys: true }
  announce(describe(cell, now))
  return cell
}

function pan([dx, dy]: Cell, now: Scenario, size: CanvasSize): void {
  const step = Math.round(0.1 * Math.min(size.width, size.height))
  viewpoint.value = panBy(viewpoint.peek(), -dx * step, -dy * step, size, now.spec)
}

/** A goal under the cursor is taken up, for the goal tool to put down elsewhere; the wall tools leave start and goals alone. */
function use(cell: Cell, now: Scenario): void {
  const brush = brushFor(tool.peek(), now, cell, activeGoal.peek())
  if (brush === null) {
    refuseMoreGoals()
    return
  }
  const taken = goalIndexAt(now, cell) >= 0
  if (brush.kind === 'goal') activeGoal.value = brush.index
  applyEdit(stroke(brush, cell, cell), newGesture())
  const after = scenario.peek() ?? now
  announce(
    taken
      ? t('stage.taken', { name: goalName(now.spec, activeGoal.peek()) })
      : describe(cell, after),
  )
}

/** True when there was a goal to remove, even if it is the last one and stays. */
function remove(cell: Cell | null, now: Scenario): boolean {
  const index = cell === null ? -1 : goalIndexAt(now, cell)
  if (cell === null || index < 0) return false
  applyEdit({ kind: 'remove-goal', index })
  const gone = scenario.peek() !== now
  announce(t(gone ? 'goals.removed' : 'goals.lastStays', { name: goalName(now.spec, index) }))
  return true
}

/** By slices: the end under the cursor, else the one that its tool moves. */
function lift(cell: Cell | null, now: Scenario, delta: number): boolean {
  if (!now.spec.terrain?.slices) return false
  const at = cell ?? now.spec.start
  const onGoal = goalIndexAt(now, at) >= 0
  const onStart = sameCell(at, now.spec.start)
  const end = onGoal || (!onStart && tool.peek() === 'goal') ? 'goal' : 'start'
  changeLevel(end, delta)
  return true
}

function describe(cell: Cell, now: Scenario): string {
  const told = t('stage.cell', { x: cell[0], y: cell[1], what: contentOf(cell, now) })
  return placeShown(now, cell).reduce(
    (words, height) => t('relief.withHeight', { words, height }),
    told,
  )
}

function contentOf(cell: Cell, now: Scenario): string {
  if (sameCell(cell, now.spec.start)) return t('stage.start')
  const goal = goalIndexAt(now, cell)
  if (goal >= 0 && now.spec.goals.length > 1)
    return t('stage.goalNamed', { name: goalName(now.spec, goal) })
  if (goal >= 0) return t('stage.goal')
  return t(isBlocked(now, cell) ? 'stage.wall' : 'stage.free')
}

function clamp(value: number, size: number): number {
  return Math.min(size - 1, Math.max(0, value))
}
