/** Keys of the further tools, on a focused map and anywhere on the page. */
import type { Signal } from '@preact/signals'
import { t } from '../i18n/editor'
import type { Cell } from '../model/cell'
import { areaBetween } from '../model/spans'
import { ARROWS, STRIDE } from '../stage/keyboard'
import type { Cursor } from '../stage/panel_view'
import { announce, type FurtherTool, scenario, tool } from '../state'
import { corner, stepBrushSize } from './hand'
import {
  canPaste,
  copy,
  cut,
  free,
  nudge,
  paste,
  select,
  selectAll,
  selection,
  unselect,
} from './selection'
import { drawByKey } from './shapes'

const TOOL_KEYS: Record<string, FurtherTool> = {
  l: 'line',
  b: 'rectangle',
  n: 'block',
  d: 'fill',
  u: 'ground',
  m: 'select',
}

export function shortcut(key: string): void {
  const chosen = TOOL_KEYS[key]
  if (chosen) tool.value = chosen
  else stepBrushSize(key === 'k' ? 1 : -1)
}

/** True when the tool in hand has handled the key. */
export function handleKey(event: KeyboardEvent, cursor: Signal<Cursor | null>): boolean {
  const now = scenario.peek()
  if (now === null) return false
  const at = cursor.peek()?.cell ?? null
  const { key } = event
  if (event.ctrlKey || event.metaKey) return tool.peek() === 'select' && commandKey(event, at)
  if (event.altKey) return false
  if (key === 'Escape' && corner.peek()) {
    corner.value = null
    announce(t('editor.dropped'))
    return true
  }
  if (tool.peek() === 'select' && selectKey(event, at ?? now.spec.start)) return true
  return (key === 'Enter' || key === 'x') && drawByKey(at ?? now.spec.start)
}

function commandKey({ key, shiftKey }: KeyboardEvent, at: Cell | null): boolean {
  const arrow = ARROWS[key]
  if (arrow && !shiftKey && selection.peek()) {
    nudge([arrow[0] * STRIDE, arrow[1] * STRIDE])
    return true
  }
  const command = commandFor(key.toLowerCase(), at)
  command?.()
  return command !== null
}

/** Null where there is nothing to copy or paste: then the page, or the browser, has the key. */
function commandFor(key: string, at: Cell | null): (() => void) | null {
  const part = selection.peek()
  switch (key) {
    case 'c':
      return part && copy
    case 'x':
      return part && cut
    case 'v':
      return canPaste.peek() ? () => paste(at) : null
    case 'a':
      return selectAll
    default:
      return null
  }
}

function selectKey({ key, shiftKey }: KeyboardEvent, at: Cell): boolean {
  if (key === 'Enter' || key === 'x') {
    markCorner(at)
    return true
  }
  // While a corner waits for the other one, arrows move the cursor.
  if (!selection.peek() || corner.peek()) return false
  const arrow = ARROWS[key]
  if (arrow && !shiftKey) nudge(arrow)
  else if (key === 'Delete' || key === 'Backspace') free()
  else if (key === 'Escape') unselect()
  else return false
  return true
}

function markCorner(at: Cell): void {
  const from = corner.peek()
  corner.value = from ? null : at
  if (from) select(areaBetween(from, at))
  else announce(t('editor.from', { tool: t('editor.tools.select'), x: at[0], y: at[1] }))
}
