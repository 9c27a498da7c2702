/** Takes a run towards targets, a time slice at a time. */
import type { Run, Status } from '@pkg/formicarium'
import type { Target } from '../model/messages'

/** The part of a Run that stepping needs; it may stand still before its end. */
export interface Steppable extends Pick<Run, 'iteration' | 'summary'> {
  advance(by: 'move' | 'iteration', count: number): Status | 'stopped'
  status(): Status | 'stopped'
}

/** Moves between two looks at the clock: about 20 µs of work for a colony of fifty. */
const MOVES_PER_LOOK = 16

export class Stepper {
  /** What the last iteration took; unknown ones are taken move by move, so that a slice is never overrun by much. */
  private iterationMs = Number.POSITIVE_INFINITY
  private spentMs = 0
  private iteration = 0

  constructor(
    private readonly run: Steppable,
    private readonly now: () => number,
  ) {}

  /** True when the target was reached or the run has ended; false when the slice was spent first. */
  advance(target: Target, sliceMs: number): boolean {
    const deadline = this.now() + sliceMs
    switch (target.kind) {
      case 'moves':
        this.makeMoves(target)
        return true
      case 'iterations':
        return this.until(this.atIteration(this.run.iteration() + target.count), deadline, 1)
      case 'until-iteration':
        return this.until(this.atIteration(target.iteration), deadline, 1)
      case 'until-paths':
        return this.until(this.atPaths(target.paths), deadline, 1)
      case 'slice':
        this.until(() => false, deadline, MOVES_PER_LOOK)
        return true
    }
  }

  /** Counted moves ignore the clock: the counts are small, and panels that count moves must all make the same number. */
  private makeMoves(target: Extract<Target, { kind: 'moves' }>): void {
    const { count, untilIteration, untilPaths } = target
    if (untilIteration === undefined && untilPaths === undefined) {
      this.run.advance('move', count)
      return
    }
    const met =
      untilIteration === undefined
        ? this.atPaths(untilPaths ?? 0)
        : this.atIteration(untilIteration)
    for (let made = 0; made < count && this.run.status() === 'running' && !met(); made++) {
      this.run.advance('move', 1)
    }
  }

  /** Whole iterations where they fit into what is left of the slice, else `stride` moves at a time. */
  private until(met: () => boolean, deadline: number, stride: number): boolean {
    let status = this.run.status()
    let looked = this.now()
    for (let made = 1; status === 'running' && !met(); made++) {
      const whole = this.iterationMs < (deadline - looked) / 2
      status = this.run.advance(whole ? 'iteration' : 'move', whole ? 1 : stride)
      if (!whole && stride === 1 && made % MOVES_PER_LOOK !== 0) continue
      const now = this.now()
      this.time(now - looked)
      looked = now
      if (now >= deadline) return status !== 'running' || met()
    }
    return true
  }

  private time(passedMs: number): void {
    this.spentMs += passedMs
    const finished = this.run.iteration() - this.iteration
    if (finished <= 0) return
    this.iterationMs = this.spentMs / finished
    this.iteration += finished
    this.spentMs = 0
  }

  private atIteration(iteration: number): () => boolean {
    return () => this.run.iteration() >= iteration
  }

  /** Paths are counted per iteration, and a summary is costly, so it is asked for only when an iteration has ended. */
  private atPaths(paths: number): () => boolean {
    let asked = -1
    let count = 0
    return () => {
      const iteration = this.run.iteration()
      if (iteration !== asked) {
        asked = iteration
        count = this.run.summary().effort.constructed_paths
      }
      return count >= paths
    }
  }
}
