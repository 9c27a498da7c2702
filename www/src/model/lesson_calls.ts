/** What a worker of its own does for a lesson: one ant of a run, and a path that is drawn by hand. */
import type { AntTurn, Drawn } from '@pkg/formicarium'
import type { Cell } from './cell'
import type { RunSetup } from './messages'
import type { WholeMap } from './tool_calls'

/** Where the look at a run has come. */
export interface Followed {
  /** False when there was not time enough; ask again. */
  arrived: boolean
  /** Finished iterations; fewer than asked for where the run has ended before. */
  iteration: number
  /** Moves made of the iteration after that. */
  moves: number
  /** Whether that iteration has ended. */
  over: boolean
  /** Over the finished iterations, to be held against that of the run on the page. */
  digest: string
}

export interface LessonCalls {
  /** Repeats this run from now on, apart from the one on the page. */
  followRun(setup: RunSetup): void
  /** Goes to where the run has made so many moves after an iteration; works at most so many milliseconds. */
  followTo(iteration: number, moves: number, milliseconds: number): Followed
  followedAnt(number: number): AntTurn | null
  /** The cell of each ant, x and y, −1 for lost ones; empty before the first move. */
  followedAnts(): Int32Array

  drawOn(...map: WholeMap): void
  drawTowards(from: Cell, to: Cell): Cell[]
  measureDrawn(path: Cell[]): Drawn
}
