/** What a tool does to the cell under it: one rule for pointer, touch and keys. */
import { type Cell, type Edit, goalOf, isBlocked, sameCell } from '../maps/edit'
import type { Scenario } from '../session'
import type { Tool } from '../state'

/** One drag, or one key press: decided at its first cell, kept to its end. */
export type Brush = { kind: 'wall'; blocked: boolean } | { kind: 'start' } | { kind: 'goal' }

/**
 * Start and goal can be taken up with any tool; else the tool decides, and for walls the first cell: on a free cell the drag
 * builds walls, on a wall it removes them.
 */
export function brushFor(tool: Tool, scenario: Scenario, at: Cell): Brush | null {
  if (sameCell(at, scenario.spec.start)) return { kind: 'start' }
  if (sameCell(at, goalOf(scenario))) return { kind: 'goal' }
  switch (tool) {
    case 'wall':
      return { kind: 'wall', blocked: !isBlocked(scenario, at) }
    case 'erase':
      return { kind: 'wall', blocked: false }
    case 'start':
    case 'goal':
      return { kind: tool }
    case 'pan':
      return null
  }
}

/** What a brush does on its way from one cell to another. */
export function stroke(brush: Brush, from: Cell, to: Cell): Edit {
  return brush.kind === 'wall'
    ? { kind: 'paint', from, to, blocked: brush.blocked }
    : { kind: brush.kind, at: to }
}

let lastGesture = 0

/** A number for the edits that are undone together. */
export function newGesture(): number {
  return ++lastGesture
}
