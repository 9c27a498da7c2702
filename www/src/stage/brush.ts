/** What a tool does to the cell under it: one rule for pointer, touch and keys. */
import type { Cell } from '../model/cell'
import { type Edit, isBlocked, sameCell } from '../model/edit'
import { limits } from '../model/facts'
import { goalIndexAt } from '../model/goals'
import type { Scenario } from '../model/session'
import type { Tool } from '../state'

/** One drag, or one key press: decided at its first cell, kept to its end. */
export type Brush =
  | { kind: 'wall'; blocked: boolean }
  | { kind: 'start' }
  /** The index after the last goal adds one. */
  | { kind: 'goal'; index: number }

/**
 * Start and goals can be taken up with any tool; else the tool decides, and for walls the first cell: on a free cell the drag
 * builds walls, on a wall it removes them. `active`: the goal that the goal tool moves.
 */
export function brushFor(tool: Tool, scenario: Scenario, at: Cell, active: number): Brush | null {
  if (sameCell(at, scenario.spec.start)) return { kind: 'start' }
  const here = goalIndexAt(scenario, at)
  if (here >= 0) return { kind: 'goal', index: here }
  const { length } = scenario.spec.goals
  switch (tool) {
    case 'wall':
      return { kind: 'wall', blocked: !isBlocked(scenario, at) }
    case 'erase':
      return { kind: 'wall', blocked: false }
    case 'start':
      return { kind: 'start' }
    case 'goal':
      return { kind: 'goal', index: Math.min(active, length - 1) }
    case 'add-goal':
      return length < limits.max_goals ? { kind: 'goal', index: length } : null
    default:
      return null
  }
}

/** What a brush does on its way from one cell to another. */
export function stroke(brush: Brush, from: Cell, to: Cell): Edit {
  switch (brush.kind) {
    case 'wall':
      return { kind: 'paint', from, to, blocked: brush.blocked }
    case 'start':
      return { kind: 'start', at: to }
    case 'goal':
      return { kind: 'goal', index: brush.index, at: to }
  }
}

let lastGesture = 0

/** A number for the edits that are undone together. */
export function newGesture(): number {
  return ++lastGesture
}
