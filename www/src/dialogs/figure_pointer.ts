/** What a pointer does to a figure: one step back a gesture. */
import { useRef } from 'preact/hooks'
import type { Cell } from '../model/cell'
import { cellsBetween, type Draft, toggled, withLattice } from './figure_draft'
import {
  cellUnder,
  dragged,
  HANDLES,
  type Handle,
  handlePlace,
  moved,
  type Place,
} from './figure_lattice'
import type { Pencil } from './figure_pencil'
import type { FigureState } from './figure_state'

export const TOOLS = ['walls', 'start', 'goal', 'lattice'] as const
export type Tool = (typeof TOOLS)[number]

export interface FigurePointer {
  /** `near`: how far from a handle it is still meant, in pixels of the picture. */
  press: (at: Place, near: number) => void
  move: (at: Place) => void
  /** Not `kept`: the browser has taken the gesture for its own. */
  release: (kept: boolean) => void
}

type Gesture =
  | { does: 'drag'; handle: Handle | null; from: Place; before: Draft; id: number }
  | { does: 'end'; id: number }
  | { does: 'paint'; mark: 'free' | 'wall'; last: Cell; id: number }

let gestures = 0

export function useFigurePointer(
  { draft, change, undo }: FigureState,
  tool: Tool,
  pencil: Pencil | null,
): FigurePointer {
  const gesture = useRef<Gesture | null>(null)
  const paintFrom = (cell: Cell, id: number) => {
    if (!pencil) return
    const mark = toggled(pencil.markAt(cell))
    gesture.current = { does: 'paint', mark, last: cell, id }
    pencil.paint([cell], mark, id)
  }
  return {
    press: (at, near) => {
      if (!draft) return
      const id = ++gestures
      const cell = cellUnder(draft.lattice, at)
      if (tool === 'lattice') {
        const handle = handleNear(draft, at, near)
        if (handle || cell) gesture.current = { does: 'drag', handle, from: at, before: draft, id }
      } else if (cell && tool === 'walls') paintFrom(cell, id)
      else if (cell && tool !== 'walls') {
        gesture.current = { does: 'end', id }
        pencil?.putEnd(cell, tool, id)
      }
    },
    move: (at) => {
      const now = gesture.current
      const cell = draft && cellUnder(draft.lattice, at)
      if (now?.does === 'drag') drag(now, at, change)
      else if (
        now?.does === 'paint' &&
        cell &&
        (cell[0] !== now.last[0] || cell[1] !== now.last[1])
      ) {
        pencil?.paint(cellsBetween(now.last, cell), now.mark, now.id, true)
        gesture.current = { ...now, last: cell }
      }
    },
    release: (kept) => {
      if (gesture.current && !kept) undo(gesture.current.id)
      gesture.current = null
    },
  }
}

function drag(
  { handle, from, before, id }: Extract<Gesture, { does: 'drag' }>,
  at: Place,
  change: FigureState['change'],
): void {
  const by = [at[0] - from[0], at[1] - from[1]] as const
  // A press alone moves nothing.
  if (by[0] === 0 && by[1] === 0) return
  const { lattice } = before
  change(withLattice(handle ? dragged(lattice, handle, by) : moved(lattice, by)), id)
}

/** The nearest handle, if it is near enough. */
function handleNear({ lattice }: Draft, [x, y]: Place, near: number): Handle | null {
  const far = (handle: Handle) => {
    const [atX, atY] = handlePlace(lattice, handle)
    return Math.max(Math.abs(atX - x), Math.abs(atY - y))
  }
  const [nearest] = [...HANDLES].sort((a, b) => far(a) - far(b))
  return nearest && far(nearest) <= near ? nearest : null
}
