/**
 * Keys on a focused terrain: arrows turn it, with Shift they move the cell cursor; with the tools for start and goals it is the other way
 * round. Plus and minus zoom, Home shows all. What is done at the cursor is done as on the flat map.
 */
import type { Signal } from '@preact/signals'
import { t } from '../i18n'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import { ARROWS, handleAtCursor, handleInspection, STRIDE, shiftCursor } from '../stage/keyboard'
import type { Cursor } from '../stage/panel_view'
import { announce, scenario } from '../state'
import { orbit, resetEye, shiftEye, turned, zoomEye } from './eye'
import { placesEnds } from './relief_pointer'

/** Radians a press. */
const TURN = 0.14
const TILT = 0.1
const SHIFT = 0.05

export function reliefKeyHandler(
  cursor: Signal<Cursor | null>,
  inspect: (cell: Cell) => void,
): (event: KeyboardEvent) => void {
  return (event) => {
    const now = scenario.peek()
    if (now === null || event.metaKey || event.altKey) return
    if (handleInspection(event, now, cursor, inspect) || handle(event, now, cursor)) {
      event.preventDefault()
      event.stopPropagation()
    }
  }
}

function handle(event: KeyboardEvent, now: Scenario, cursor: Signal<Cursor | null>): boolean {
  const arrow = ARROWS[event.key]
  if (arrow) {
    const [x, y] = arrow
    const steps = event.ctrlKey ? STRIDE : 1
    if (event.shiftKey !== placesEnds()) {
      const [dx, dy] = turned([x * steps, y * steps])
      shiftCursor([dx, dy], now, cursor)
    } else if (event.ctrlKey) shiftEye(SHIFT * x, -SHIFT * y, now.spec.width, now.spec.height)
    else orbit(TURN * x, -TILT * y)
    return true
  }
  if (event.ctrlKey) return false
  switch (event.key) {
    case '+':
    case '=':
      zoomEye(1.25)
      return true
    case '-':
      zoomEye(0.8)
      return true
    case 'Home':
    case '0':
      resetEye()
      announce(t('relief.reset'))
      return true
    case 'Enter':
    case 'x':
      if (placesEnds()) return handleAtCursor(event, now, cursor)
      announce(t('relief.wallsFlat'))
      return true
    default:
      return handleAtCursor(event, now, cursor)
  }
}
