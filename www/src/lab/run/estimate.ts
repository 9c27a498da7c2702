/** How long the rest of the runs will take: entries differ a thousandfold, so each pair of map and entry is reckoned by its own runs. */
import type { Tasks } from './tasks'

/** Fewer runs, or a shorter time, say nothing yet. */
const LEAST_RUNS = 3
const LEAST_SECONDS = 0.7
/** What came last counts most: the machine may have got other work meanwhile. */
const MEMORY_SECONDS = 20

interface Mean {
  sum: number
  count: number
}

export class Estimate {
  private readonly byPair: Mean[]
  private readonly all: Mean = { sum: 0, count: 0 }
  /** Seconds of work done, and of the clock, faded out. */
  private worked = 0
  private passed = 0
  private last: number

  constructor(
    private readonly tasks: Tasks,
    now: number,
  ) {
    this.byPair = Array.from({ length: tasks.pairs }, () => ({ sum: 0, count: 0 }))
    this.last = now
  }

  /** The clock goes on after a pause. */
  resume(now: number): void {
    this.last = now
  }

  done(index: number, seconds: number, now: number): void {
    const pair = this.byPair[this.tasks.pairOf(index)]
    for (const mean of pair ? [pair, this.all] : [this.all]) {
      mean.sum += seconds
      mean.count += 1
    }
    const step = Math.max(0, now - this.last)
    const fade = Math.exp(-step / MEMORY_SECONDS)
    this.worked = this.worked * fade + seconds
    this.passed = this.passed * fade + step
    this.last = now
  }

  /** Null while nobody can tell. */
  secondsLeft(left: Iterable<number>): number | null {
    if (this.all.count < LEAST_RUNS || this.passed < LEAST_SECONDS) return null
    const mean = this.all.sum / this.all.count
    let work = 0
    for (const index of left) {
      const pair = this.byPair[this.tasks.pairOf(index)]
      work += pair && pair.count > 0 ? pair.sum / pair.count : mean
    }
    // How much work is done in a second by all workers together, messages and drawing included.
    const rate = this.worked / this.passed
    return rate > 0 ? work / rate : null
  }
}
