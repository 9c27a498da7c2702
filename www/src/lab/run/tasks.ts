/** The runs of a question as the engine numbers them: by instance, then entry, then seed. */
import { countRuns, type Question } from '../../model/comparison'

export interface Place {
  instance: number
  /** Among the entries that can be run. */
  entry: number
  /** From the question's first seed on. */
  seed: number
}

export class Tasks {
  readonly count: number
  /** Pairs of instance and entry. */
  readonly pairs: number
  private readonly seeds: number

  constructor(question: Question) {
    this.count = countRuns(question)
    this.seeds = question.seeds.count
    this.pairs = this.seeds > 0 ? this.count / this.seeds : 0
  }

  seedOf(index: number): number {
    return index % this.seeds
  }

  /** Number of a run's pair of instance and entry. */
  pairOf(index: number): number {
    return Math.floor(index / this.seeds)
  }

  /** Seed by seed, so that every entry has runs early on. Only the first `seeds` seeds of each entry. */
  inOrder(seeds = this.seeds): number[] {
    const order: number[] = []
    for (let seed = 0; seed < Math.min(seeds, this.seeds); seed++)
      for (let pair = 0; pair < this.pairs; pair++) order.push(pair * this.seeds + seed)
    return order
  }
}
