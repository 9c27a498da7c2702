/** The tool in hand over a figure, the cell cursor, and what keys do with both. */
import { useState } from 'preact/hooks'
import type { Cell } from '../model/cell'
import { cellAt, nextUnsure, placeOf, toggled } from './figure_draft'
import { cellUnder, type Place } from './figure_lattice'
import { type Pencil, pencilFor } from './figure_pencil'
import { type FigurePointer, type Tool, useFigurePointer } from './figure_pointer'
import { ZOOMS } from './figure_sight'
import type { FigureState } from './figure_state'

export interface FigureHand extends FigurePointer {
  tool: Tool
  choose: (tool: Tool) => void
  /** An index of ZOOMS. */
  zoom: number
  zoomTo: (zoom: number) => void
  /** The cell of the keyboard. */
  cursor: Cell | null
  /** The cell that is told about: under the cursor of the keyboard, or of the pointer. */
  pointed: Cell | null
  toNextUnsure: () => void
  onKey: (event: KeyboardEvent) => void
}

const ARROWS: Record<string, Cell> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
}
/** Cells that Ctrl with an arrow goes, as on the page's maps. */
const STRIDE = 10

export function useFigureHand(figure: FigureState): FigureHand {
  const { draft, classes, found } = figure
  const [chosen, choose] = useState<Tool | null>(null)
  const [zoom, setZoom] = useState(0)
  const [placed, setCursor] = useState<Cell | null>(null)
  const [hovered, setHovered] = useState<Cell | null>(null)
  // What is found needs corrected cells at most; by hand the lattice comes first.
  const tool = chosen ?? (draft && !found ? 'lattice' : 'walls')
  const pencil = pencilFor(figure)
  const pointer = useFigurePointer(figure, tool, pencil)
  const { columns, rows } = draft?.lattice ?? { columns: 0, rows: 0 }
  const inside = (cell: Cell | null) => (cell && cell[0] < columns && cell[1] < rows ? cell : null)
  const cursor = inside(placed)
  const zoomTo = (to: number) => setZoom(Math.min(ZOOMS.length - 1, Math.max(0, to)))
  const toNextUnsure = () => {
    if (!draft || !classes) return
    const next = nextUnsure(classes, cursor ? cellAt(cursor, draft.lattice) : -1)
    if (next >= 0) setCursor(placeOf(next, draft.lattice))
  }
  return {
    tool,
    choose,
    zoom,
    zoomTo,
    cursor,
    pointed: cursor ?? inside(hovered),
    toNextUnsure,
    ...pointer,
    press: (at: Place, near: number) => {
      setCursor(null)
      pointer.press(at, near)
    },
    move: (at: Place) => {
      const cell = draft && cellUnder(draft.lattice, at)
      setHovered((before) => (cell && before && isSame(cell, before) ? before : cell))
      pointer.move(at)
    },
    onKey: (event) => {
      if (event.altKey || event.metaKey || !draft) return
      const to = moveOf(event, cursor, [columns, rows])
      const at = to ?? cursor ?? [0, 0]
      const isDone = to !== null || (!event.ctrlKey && actByKey(event, at, pencil))
      if (isDone) setCursor(at)
      else if (event.ctrlKey || !viewByKey(event, zoom, zoomTo, toNextUnsure)) return
      event.preventDefault()
      event.stopPropagation()
    },
  }
}

const isSame = (a: Cell, b: Cell) => a[0] === b[0] && a[1] === b[1]

/** Where an arrow leads; the first one to the first cell. Null for any other key. */
function moveOf({ key, ctrlKey }: KeyboardEvent, cursor: Cell | null, sides: Cell): Cell | null {
  const arrow = ARROWS[key]
  if (!arrow) return null
  const steps = ctrlKey ? STRIDE : 1
  const along = (i: 0 | 1) => {
    const to = cursor ? cursor[i] + steps * arrow[i] : 0
    return Math.min(sides[i] - 1, Math.max(0, to))
  }
  return [along(0), along(1)]
}

/** True when the key corrects a cell. */
function actByKey({ key }: KeyboardEvent, at: Cell, pencil: Pencil | null): boolean {
  const letter = key.toLowerCase()
  if (key === ' ') pencil?.paint([at], toggled(pencil.markAt(at)))
  else if (letter === 's') pencil?.putEnd(at, 'start')
  else if (letter === 'g') pencil?.putEnd(at, 'goal')
  else return false
  return true
}

/** True when the key changes what is seen. */
function viewByKey(
  { key }: KeyboardEvent,
  zoom: number,
  zoomTo: FigureHand['zoomTo'],
  toNextUnsure: () => void,
): boolean {
  if (key === '+' || key === '=') zoomTo(zoom + 1)
  else if (key === '-') zoomTo(zoom - 1)
  else if (key.toLowerCase() === 'n') toNextUnsure()
  else return false
  return true
}
