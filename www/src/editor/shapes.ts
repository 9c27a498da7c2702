/** Walls by brush, line, rectangle and fill: what a press draws, what keys draw, and what either would draw. */
import { t } from '../i18n/editor'
import type { Cell } from '../model/cell'
import { isBlocked } from '../model/edit'
import type { Scenario } from '../model/session'
import {
  areaBetween,
  areaSpans,
  borderSpans,
  floodSpans,
  lineSpans,
  numbersOf,
  type Span,
  squareAbout,
  squared,
  straightened,
} from '../model/spans'
import type { Press, Stroke } from '../model/stroke'
import { newGesture } from '../stage/brush'
import { announce, applyEdit, scenario, type Tool, tool } from '../state'
import { brushSize, corner, sketch, straight } from './hand'

export type Shape = 'line' | 'rectangle' | 'block'

export const isShape = (id: Tool): id is Shape =>
  id === 'line' || id === 'rectangle' || id === 'block'
/** A brush of one cell is the page's own. */
const isWideBrush = (id: Tool) => (id === 'wall' || id === 'erase') && brushSize.value > 1

/** Null where the tool in hand is none of these. */
export function wallStroke(press: Press): Stroke | null {
  const [now, id] = [scenario.peek(), tool.peek()]
  if (now === null) return null
  const blocked = builds(id, press.cell, now)
  if (isWideBrush(id)) return brushStroke(press.cell, blocked, now)
  if (isShape(id)) return shapeStroke(id, press.cell, blocked, now)
  if (id === 'fill') return fillStroke(press.cell, blocked, now)
  return null
}

/** The first cell decides: from a free one walls are built, from a wall they are torn down. */
const builds = (id: Tool, at: Cell, now: Scenario) => id !== 'erase' && !isBlocked(now, at)

function brushStroke(from: Cell, blocked: boolean, { spec }: Scenario): Stroke {
  const gesture = newGesture()
  let last = from
  return {
    go(cell) {
      put(lineSpans(last, cell, brushSize.peek(), spec), blocked, spec, gesture)
      last = cell
    },
  }
}

function shapeStroke(shape: Shape, from: Cell, blocked: boolean, { spec }: Scenario): Stroke {
  return {
    go(cell, { shiftKey }) {
      sketch.value = {
        spans: spansOf(shape, from, guided(shape, from, cell, shiftKey), spec),
        blocked,
      }
    },
    end() {
      if (sketch.peek()) put(sketch.peek()?.spans ?? [], blocked, spec)
      sketch.value = null
    },
    drop() {
      sketch.value = null
    },
  }
}

function fillStroke(at: Cell, blocked: boolean, now: Scenario): Stroke {
  return {
    go() {},
    end: () => put(floodSpans(now, at), blocked, now.spec),
  }
}

/** Shift is the other way round for as long as it is held. */
function guided(shape: Shape, from: Cell, to: Cell, shiftKey = false): Cell {
  if (shiftKey === straight.value) return to
  return shape === 'line' ? straightened(from, to) : squared(from, to)
}

function spansOf(shape: Shape, from: Cell, to: Cell, spec: Scenario['spec']): Span[] {
  switch (shape) {
    case 'line':
      return lineSpans(from, to, brushSize.value, spec)
    case 'rectangle':
      return borderSpans(from, to, brushSize.value, spec)
    case 'block':
      return areaSpans(areaBetween(from, to), spec)
  }
}

function put(spans: Span[], blocked: boolean, spec: Scenario['spec'], gesture?: number): void {
  applyEdit({ kind: 'cells', cells: numbersOf(spans, spec), blocked }, gesture)
}

/** What Enter at this cell, or a press there, would draw; null where the page's own cursor tells enough. Read inside an effect. */
export function wouldDraw(at: Cell): { spans: Span[]; blocked: boolean } | null {
  const [now, id] = [scenario.value, tool.value]
  if (now === null) return null
  const from = corner.value ?? at
  const blocked = builds(id, from, now)
  if (isWideBrush(id)) return { spans: squareAbout(at, brushSize.value, now.spec), blocked }
  if (isShape(id)) return { spans: spansOf(id, from, guided(id, from, at), now.spec), blocked }
  if (id === 'fill') return { spans: floodSpans(now, at), blocked }
  return null
}

/** Enter with one of these tools; false where the page's own brush is in hand. */
export function drawByKey(at: Cell): boolean {
  const [before, id] = [scenario.peek(), tool.peek()]
  const drawing = wouldDraw(at)
  if (before === null || drawing === null) return false
  if (isShape(id) && corner.peek() === null) {
    corner.value = at
    announce(t('editor.from', { tool: t(`editor.tools.${id}`), x: at[0], y: at[1] }))
    return true
  }
  put(drawing.spans, drawing.blocked, before.spec)
  corner.value = null
  const name = id === 'erase' ? t('tools.erase') : t(`editor.tools.${id as Shape}`)
  announce(t('editor.drawn', { tool: name, count: changed(before, scenario.peek() ?? before) }))
  return true
}

function changed(before: Scenario, after: Scenario): number {
  return before.cells.reduce((sum, cell, i) => sum + Number(cell !== after.cells[i]), 0)
}
