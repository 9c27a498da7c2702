/** How long the remaining runs will take. Entries differ a thousandfold, so each pair of map and entry is estimated from its own runs. */
import type { KeptRun } from '../../model/comparison_calls'
import type { Tasks } from './tasks'

/** No estimate from fewer runs, or after a shorter time. */
const LEAST_RUNS = 3
const LEAST_SECONDS = 0.7
/** Recent runs count most: the machine may have other work by now. */
const MEMORY_SECONDS = 20

/**
 * Seconds of work of all tasks together, from the runs that were timed here: of an entry on a map without one the mean of all counts.
 * Null while there are too few.
 */
export function workOf(tasks: Tasks, all: number[], timed: Iterable<KeptRun>): number | null {
  const byPair = new Map<string, Mean>()
  const over: Mean = { sum: 0, count: 0 }
  for (const { index, seconds } of timed) {
    const took = seconds.at(-1)
    if (took === undefined) continue
    const pair = byPair.get(tasks.pairOf(index)) ?? { sum: 0, count: 0 }
    byPair.set(tasks.pairOf(index), pair)
    for (const mean of [pair, over]) {
      mean.sum += took
      mean.count += 1
    }
  }
  if (over.count < LEAST_RUNS) return null
  const meanOf = ({ sum, count }: Mean) => sum / count
  return all.reduce((sum, index) => sum + meanOf(byPair.get(tasks.pairOf(index)) ?? over), 0)
}

interface Mean {
  sum: number
  count: number
}

export class Estimate {
  private readonly byPair = new Map<string, Mean>()
  private readonly all: Mean = { sum: 0, count: 0 }
  /** Seconds of work and of the clock, with the past fading out. */
  private worked = 0
  private passed = 0
  private last: number

  constructor(
    private readonly tasks: Tasks,
    now: number,
  ) {
    this.last = now
  }

  /** The clock goes on after a pause. */
  resume(now: number): void {
    this.last = now
  }

  done(index: number, seconds: number, now: number): void {
    const key = this.tasks.pairOf(index)
    const pair = this.byPair.get(key) ?? { sum: 0, count: 0 }
    this.byPair.set(key, pair)
    for (const mean of [pair, this.all]) {
      mean.sum += seconds
      mean.count += 1
    }
    const step = Math.max(0, now - this.last)
    const fade = Math.exp(-step / MEMORY_SECONDS)
    this.worked = this.worked * fade + seconds
    this.passed = this.passed * fade + step
    this.last = now
  }

  /** Null while there is too little to go by. */
  secondsLeft(left: Iterable<number>): number | null {
    if (this.all.count < LEAST_RUNS || this.passed < LEAST_SECONDS) return null
    const mean = this.all.sum / this.all.count
    let work = 0
    for (const index of left) {
      const pair = this.byPair.get(this.tasks.pairOf(index))
      work += pair ? pair.sum / pair.count : mean
    }
    // Seconds of work that all workers do in a second of the clock, messages and drawing included.
    const rate = this.worked / this.passed
    return rate > 0 ? work / rate : null
  }
}
