/** Undo and redo over whole scenarios: they are immutable and share what an edit left alone, so a snapshot is one reference. */
import { type ReadonlySignal, signal } from '@preact/signals'
import type { Scenario } from '../model/session'

export interface History {
  /** Notes a change. Changes of the same gesture (one drag) are undone together. */
  record(before: Scenario, after: Scenario, gesture?: number): void
  /** The scenario to go back to, or null at the end. */
  undo(current: Scenario): Scenario | null
  redo(current: Scenario): Scenario | null
  canUndo: ReadonlySignal<boolean>
  canRedo: ReadonlySignal<boolean>
  clear(): void
}

const MOST_STEPS = 200
/** Large maps keep fewer steps: the cells of all snapshots together stay below this. */
const MOST_CELLS = 64 << 20

export function createHistory(): History {
  const past: Scenario[] = []
  const future: Scenario[] = []
  let lastGesture: number | undefined
  const canUndo = signal(false)
  const canRedo = signal(false)

  function settled(): void {
    canUndo.value = past.length > 0
    canRedo.value = future.length > 0
  }

  function step(from: Scenario[], to: Scenario[], current: Scenario): Scenario | null {
    const target = from.pop() ?? null
    if (target !== null) to.push(current)
    lastGesture = undefined
    settled()
    return target
  }

  return {
    canUndo,
    canRedo,
    record(before, after, gesture) {
      if (before === after) return
      future.length = 0
      if (gesture === undefined || gesture !== lastGesture) past.push(before)
      lastGesture = gesture
      trim(past)
      settled()
    },
    undo: (current) => step(past, future, current),
    redo: (current) => step(future, past, current),
    clear() {
      past.length = 0
      future.length = 0
      lastGesture = undefined
      settled()
    },
  }
}

function trim(past: Scenario[]): void {
  let cells = past.reduce((sum, scenario) => sum + scenario.cells.length, 0)
  while (past.length > MOST_STEPS || (past.length > 1 && cells > MOST_CELLS)) {
    cells -= past.shift()?.cells.length ?? 0
  }
}
