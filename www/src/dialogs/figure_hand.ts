/** What pointer and keys do to a figure: one tool at a time, one step back a gesture. */
import { useRef, useState } from 'preact/hooks'
import type { Cell } from '../model/cell'
import {
  cellAt,
  cellsBetween,
  type Draft,
  ended,
  type Mark,
  markOf,
  nextUnsure,
  painted,
  placeOf,
  toggled,
  withLattice,
} from './figure_draft'
import {
  cellUnder,
  dragged,
  HANDLES,
  type Handle,
  handlePlace,
  moved,
  type Place,
} from './figure_lattice'
import { ZOOMS } from './figure_sight'
import type { FigureState } from './figure_state'

export const TOOLS = ['walls', 'start', 'goal', 'lattice'] as const
export type Tool = (typeof TOOLS)[number]

export interface FigureHand {
  tool: Tool
  choose: (tool: Tool) => void
  /** An index of ZOOMS. */
  zoom: number
  zoomTo: (zoom: number) => void
  cursor: Cell | null
  /** The cell that is told about: under the cursor of the keyboard, or of the pointer. */
  pointed: Cell | null
  toNextUnsure: () => void
  /** `near`: how far from a handle it is still meant, in pixels of the picture. */
  press: (at: Place, near: number) => void
  move: (at: Place) => void
  /** Not `kept`: the browser has taken the gesture for its own. */
  release: (kept: boolean) => void
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

type Gesture =
  | { does: 'drag'; handle: Handle | null; from: Place; before: Draft; id: number }
  | { does: 'paint'; mark: 'free' | 'wall'; last: Cell; id: number }

let gestures = 0

export function useFigureHand(figure: FigureState): FigureHand {
  const [chosen, setTool] = useState<Tool | null>(null)
  const [zoom, setZoom] = useState(0)
  const [cursor, setCursor] = useState<Cell | null>(null)
  const [hovered, setHovered] = useState<Cell | null>(null)
  const gesture = useRef<Gesture | null>(null)
  const { draft, classes } = figure
  // What is found needs corrected cells at most; by hand the lattice comes first.
  const tool = chosen ?? (draft && !figure.found ? 'lattice' : 'walls')
  const inside = (cell: Cell | null) => {
    const { columns, rows } = draft?.lattice ?? { columns: 0, rows: 0 }
    return cell && cell[0] < columns && cell[1] < rows ? cell : null
  }
  const markAt = (cell: Cell): Mark =>
    markOf(draft && classes ? (classes[cellAt(cell, draft.lattice)] ?? 0) : 0)

  /** Free and wall along a way; ends that are only passed over stay. */
  const paintTo = (
    cells: Cell[],
    mark: 'free' | 'wall',
    id: number | undefined,
    pressed: boolean,
  ) => {
    if (!draft || !classes) return
    const meant = cells.filter((cell) => pressed || !isEnd(markAt(cell)))
    if (meant.some((cell) => markAt(cell) !== mark))
      figure.change(
        painted(
          draft,
          meant.map((cell) => cellAt(cell, draft.lattice)),
          mark,
        ),
        id,
      )
  }
  const putEnd = (cell: Cell, end: 'start' | 'goal') => {
    if (draft && classes && markAt(cell) !== end)
      figure.change(ended(draft, classes, cellAt(cell, draft.lattice), end))
  }
  const use = (cell: Cell, id?: number) => {
    if (tool === 'start' || tool === 'goal') putEnd(cell, tool)
    else paintTo([cell], toggled(markAt(cell)), id, true)
  }
  const goTo = ([x, y]: Cell) => {
    if (!draft) return
    const within = (at: number, count: number) => Math.min(count - 1, Math.max(0, at))
    setCursor([within(x, draft.lattice.columns), within(y, draft.lattice.rows)])
  }
  const toNextUnsure = () => {
    if (!draft || !classes) return
    const next = nextUnsure(classes, cursor ? cellAt(cursor, draft.lattice) : -1)
    if (next >= 0) setCursor(placeOf(next, draft.lattice))
  }
  const zoomTo = (to: number) => setZoom(Math.min(ZOOMS.length - 1, Math.max(0, to)))

  const press = (at: Place, near: number) => {
    if (!draft) return
    gestures++
    if (tool === 'lattice') {
      const handle = handleNear(draft, at, near)
      if (handle || cellUnder(draft.lattice, at))
        gesture.current = { does: 'drag', handle, from: at, before: draft, id: gestures }
      return
    }
    const cell = cellUnder(draft.lattice, at)
    if (!cell || !classes) return
    setCursor(null)
    if (tool === 'walls')
      gesture.current = { does: 'paint', mark: toggled(markAt(cell)), last: cell, id: gestures }
    use(cell, gestures)
  }
  const move = (at: Place) => {
    if (!draft) return
    const cell = cellUnder(draft.lattice, at)
    setHovered(cell)
    const now = gesture.current
    if (now?.does === 'drag') {
      const { handle, from, before, id } = now
      const by = [at[0] - from[0], at[1] - from[1]] as const
      const { lattice } = before
      // A press alone moves nothing.
      if (by[0] === 0 && by[1] === 0) return
      figure.change(withLattice(handle ? dragged(lattice, handle, by) : moved(lattice, by)), id)
    } else if (now && cell && (cell[0] !== now.last[0] || cell[1] !== now.last[1])) {
      paintTo(cellsBetween(now.last, cell), now.mark, now.id, false)
      gesture.current = { ...now, last: cell }
    }
  }
  const release = (kept: boolean) => {
    if (gesture.current && !kept) figure.undo(gesture.current.id)
    gesture.current = null
  }

  const onKey = (event: KeyboardEvent) => {
    if (event.altKey || event.metaKey || !draft) return
    const at = inside(cursor) ?? [0, 0]
    const arrow = ARROWS[event.key]
    const steps = event.ctrlKey ? STRIDE : 1
    if (arrow) goTo(inside(cursor) ? [at[0] + steps * arrow[0], at[1] + steps * arrow[1]] : at)
    else if (event.ctrlKey) return
    else {
      const act = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key]
      if (!act) return
      if (act === 'toggle') paintTo([at], toggled(markAt(at)), undefined, true)
      else if (act === 'start' || act === 'goal') putEnd(at, act)
      else if (act === 'unsure') toNextUnsure()
      else zoomTo(zoom + (act === 'larger' ? 1 : -1))
      if (act === 'toggle' || act === 'start' || act === 'goal') setCursor(at)
    }
    event.preventDefault()
    event.stopPropagation()
  }
  return {
    tool,
    choose: setTool,
    zoom,
    zoomTo,
    cursor: inside(cursor),
    pointed: inside(cursor) ?? inside(hovered),
    toNextUnsure,
    press,
    move,
    release,
    onKey,
  }
}

const KEYS: Record<string, 'toggle' | 'start' | 'goal' | 'unsure' | 'larger' | 'smaller'> = {
  ' ': 'toggle',
  s: 'start',
  g: 'goal',
  n: 'unsure',
  '+': 'larger',
  '=': 'larger',
  '-': 'smaller',
}

const isEnd = (mark: Mark) => mark === 'start' || mark === 'goal'

/** The nearest handle, if it is near enough. */
function handleNear({ lattice }: Draft, [x, y]: Place, near: number): Handle | null {
  const far = (handle: Handle) => {
    const [atX, atY] = handlePlace(lattice, handle)
    return Math.max(Math.abs(atX - x), Math.abs(atY - y))
  }
  const [nearest] = [...HANDLES].sort((a, b) => far(a) - far(b))
  return nearest && far(nearest) <= near ? nearest : null
}
