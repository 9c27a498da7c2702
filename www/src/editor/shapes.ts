/** Walls and ground by brush, line, rectangle and fill: what a press draws, what keys draw, and what either would draw. */
import { t } from '../i18n/editor'
import type { Cell } from '../model/cell'
import { applyEditTo, isBlocked } from '../model/edit'
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
import { PLAIN, weighed } from '../model/weights'
import { newGesture } from '../stage/brush'
import { announce, applyEdit, type FurtherTool, notify, scenario, type Tool, tool } from '../state'
import {
  brushSize,
  corner,
  type Drawing,
  type DrawnShape,
  factor,
  groundShape,
  type Ink,
  sketch,
  straight,
} from './hand'

export type Shape = 'line' | 'rectangle' | 'block'

export const isShape = (id: Tool | DrawnShape): id is Shape =>
  id === 'line' || id === 'rectangle' || id === 'block'

/** How the tool in hand draws, and what, if its first cell is `at`. */
interface Hand {
  shape: DrawnShape
  ink: Ink
}

/** Null where the tool in hand is none of these. Read inside an effect. */
function handAt(at: Cell, now: Scenario): Hand | null {
  const id = tool.value
  if (id === 'ground') return { shape: groundShape.value, ink: factor.value }
  // The page's own brush of one cell knows no ground.
  if (id === 'erase' && now.factors) return { shape: 'brush', ink: 'plain' }
  // The first cell decides: from a free one walls are built, from a wall they are torn down.
  const ink = id !== 'erase' && !isBlocked(now, at) ? 'wall' : 'free'
  if (id === 'wall' || id === 'erase') return brushSize.value > 1 ? { shape: 'brush', ink } : null
  return isShape(id) || id === 'fill' ? { shape: id, ink } : null
}

/** Null where the tool in hand is none of these. */
export function wallStroke(press: Press): Stroke | null {
  const now = scenario.peek()
  const hand = now && handAt(press.cell, now)
  if (!now || !hand) return null
  if (typeof hand.ink === 'number' && now.heights) return refusedStroke()
  if (hand.shape === 'brush') return brushStroke(press.cell, hand.ink, now)
  if (hand.shape === 'fill') return fillStroke(press.cell, hand.ink, now)
  return shapeStroke(hand.shape, press.cell, hand.ink, now)
}

/** What a step costs on a terrain whose cells have factors is not defined. */
function refusedStroke(): Stroke {
  notify('warning', t('editor.noGround'), { hint: t('editor.noGroundHint') })
  return { go() {} }
}

function brushStroke(from: Cell, ink: Ink, { spec }: Scenario): Stroke {
  const gesture = newGesture()
  let last = from
  return {
    go(cell) {
      put({ spans: lineSpans(last, cell, brushSize.peek(), spec), ink }, spec, gesture)
      last = cell
    },
  }
}

function shapeStroke(shape: Shape, from: Cell, ink: Ink, { spec }: Scenario): Stroke {
  return {
    go(cell, { shiftKey }) {
      sketch.value = { spans: spansOf(shape, from, guided(shape, from, cell, shiftKey), spec), ink }
    },
    end() {
      if (sketch.peek()) put(sketch.peek() ?? { spans: [], ink }, spec)
      sketch.value = null
    },
    drop() {
      sketch.value = null
    },
  }
}

function fillStroke(at: Cell, ink: Ink, now: Scenario): Stroke {
  return {
    go() {},
    end: () => put({ spans: filled(now, at, ink), ink }, now.spec),
  }
}

/** Around a cell: walls or what is free, for ground all that costs the same. */
function filled(now: Scenario, at: Cell, ink: Ink): Span[] {
  if (typeof ink !== 'number') return floodSpans(now, at)
  return isBlocked(now, at) ? [] : floodSpans(now, at, costsOf(now))
}

/** Of each cell its factor, 0 for walls. */
const costsOf = ({ cells, factors }: Scenario): Float32Array =>
  Float32Array.from(cells, (cell, i) => (cell === 1 ? 0 : (factors?.[i] ?? PLAIN)))

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

function put({ spans, ink }: Drawing, spec: Scenario['spec'], gesture?: number): void {
  const cells = numbersOf(spans, spec)
  if (typeof ink === 'number')
    applyEdit({ kind: 'make', make: (now) => weighed(now, cells, ink) }, gesture)
  else if (ink === 'plain') applyEdit({ kind: 'make', make: (now) => erased(now, cells) }, gesture)
  else applyEdit({ kind: 'cells', cells, blocked: ink === 'wall' }, gesture)
}

/** Free cells on plain ground. */
const erased = (now: Scenario, cells: Uint32Array): Scenario =>
  weighed(applyEditTo(now, { kind: 'cells', cells, blocked: false }), cells, PLAIN)

/** What Enter at this cell, or a press there, would draw; null where the page's own cursor tells enough. Read inside an effect. */
export function wouldDraw(at: Cell): Drawing | null {
  const now = scenario.value
  const from = corner.value ?? at
  const hand = now && handAt(from, now)
  if (!hand) return null
  const { shape, ink } = hand
  if (shape === 'brush') return { spans: squareAbout(at, brushSize.value, now.spec), ink }
  if (shape === 'fill') return { spans: filled(now, at, ink), ink }
  return { spans: spansOf(shape, from, guided(shape, from, at), now.spec), ink }
}

/** Enter with one of these tools; false where the page's own brush is in hand. */
export function drawByKey(at: Cell): boolean {
  const [before, id] = [scenario.peek(), tool.peek()]
  const drawing = wouldDraw(at)
  if (before === null || drawing === null) return false
  if (typeof drawing.ink === 'number' && before.heights) {
    refusedStroke()
    return true
  }
  const name = id === 'erase' ? t('tools.erase') : t(`editor.tools.${id as FurtherTool}`)
  if (isShape(id === 'ground' ? groundShape.peek() : id) && corner.peek() === null) {
    corner.value = at
    announce(t('editor.from', { tool: name, x: at[0], y: at[1] }))
    return true
  }
  put(drawing, before.spec)
  corner.value = null
  announce(t('editor.drawn', { tool: name, count: changed(before, scenario.peek() ?? before) }))
  return true
}

function changed(before: Scenario, after: Scenario): number {
  const differs = (cell: number, i: number) =>
    cell !== after.cells[i] || (before.factors?.[i] ?? PLAIN) !== (after.factors?.[i] ?? PLAIN)
  return before.cells.reduce((sum, cell, i) => sum + Number(differs(cell, i)), 0)
}
