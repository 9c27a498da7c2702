/**
 * Undo and redo over whole scenarios: they are immutable and share what an edit left alone, so a snapshot is one reference. What is not
 * the scenario's, such as names, is exchanged with what it was before.
 */
import { type ReadonlySignal, type Signal, signal } from '@preact/signals'
import type { Scenario } from '../model/session'

/** Exchanges something with what it was before the step, or after it. */
export type Swap = () => void

/** Gives a signal another value; what comes back exchanges it with the former one. */
export function exchange<T>(of: Signal<T>, next: T): Swap {
  let other = of.peek()
  of.value = next
  return () => {
    const now = of.peek()
    of.value = other
    other = now
  }
}

export interface Step {
  /** The scenario to go to. */
  scenario: Scenario
  swap?: Swap
}

export interface History {
  /** Notes a change. Changes of the same gesture (one drag) are undone together. `swap`: what else has changed with it. */
  record(before: Scenario, after: Scenario, gesture?: number, swap?: Swap): void
  /** The step to take back, or null at the end. */
  undo(current: Scenario): Step | null
  redo(current: Scenario): Step | null
  canUndo: ReadonlySignal<boolean>
  canRedo: ReadonlySignal<boolean>
  clear(): void
}

const MOST_STEPS = 200
/** Large maps keep fewer steps: the cells of all snapshots together stay below this. */
const MOST_CELLS = 64 << 20

export function createHistory(): History {
  const past: Step[] = []
  const future: Step[] = []
  let lastGesture: number | undefined
  const canUndo = signal(false)
  const canRedo = signal(false)

  function settled(): void {
    canUndo.value = past.length > 0
    canRedo.value = future.length > 0
  }

  function step(from: Step[], to: Step[], scenario: Scenario): Step | null {
    const target = from.pop() ?? null
    if (target) to.push({ ...target, scenario })
    lastGesture = undefined
    settled()
    return target
  }

  return {
    canUndo,
    canRedo,
    record(scenario, after, gesture, swap) {
      if (scenario === after && !swap) return
      future.length = 0
      if (gesture === undefined || gesture !== lastGesture) past.push({ scenario, swap })
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

function trim(past: Step[]): void {
  let cells = past.reduce((sum, { scenario }) => sum + scenario.cells.length, 0)
  while (past.length > MOST_STEPS || (past.length > 1 && cells > MOST_CELLS)) {
    cells -= past.shift()?.scenario.cells.length ?? 0
  }
}
