/** What a session may carry for a lesson: where a race stops, a path drawn by hand, a target to beat, an ant to ask about. */
import type { Objective } from '@pkg/formicarium'
import type { Cell } from './cell'

/** A path drawn by hand may be so long, in cells. */
export const MOST_CELLS_DRAWN = 20_000
export const LONGEST_LABEL = 40
/** As many iterations as a planner may be given. */
export const MOST_ITERATIONS = 1e7

/** When a race stops by itself. Each is met by one panel, at the move where it happens. */
export type Stop =
  /** It has its first path · a better one than before · it has ended. */
  | { when: 'first-path' | 'better-path' | 'panel-ends' }
  /** So many iterations without a better path · so many iterations done. */
  | { when: 'stagnation' | 'iteration'; iterations: number }

export type StopId = Stop['when']

/** In the order of the menu. */
export const STOP_IDS: readonly StopId[] = [
  'first-path',
  'better-path',
  'stagnation',
  'iteration',
  'panel-ends',
]

/** Those that count iterations. */
export const COUNTED: readonly StopId[] = ['stagnation', 'iteration']

/** A stop that a panel has met. */
export interface MetStop {
  panelId: number
  stop: Stop
}

/** A contestant without a planner: cells from the start on, as far as the hand has come. */
export interface DrawnPath {
  label: string
  path: Cell[]
}

/** A value by an objective that is to be beaten, or the reference that is to be reached. */
export interface Target {
  objective: Objective
  beat: number | 'optimum'
}

/** The ant whose moves are to be guessed, on its walk after so many iterations. */
export interface Questions {
  /** Place of the panel, from 0. */
  panel: number
  /** From 0. */
  ant: number
  iteration: number
}

export interface Lesson {
  stops?: Stop[]
  drawn?: DrawnPath
  target?: Target
  questions?: Questions
}
