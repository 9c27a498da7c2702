/** Does the runs of the open comparison: which are missing, which are done, which have failed. */
import type { EngineError } from '@pkg/formicarium'
import { translated } from '../../i18n'
import type { KeptRun } from '../../model/comparison_calls'
import type { ComparisonWriter } from '../store/browser_storage'
import type { Failure, OpenComparison, Progress } from '../store/signals'
import type { AnalystClient } from './analyst_client'
import { Estimate } from './estimate'
import { Pool, poolSize, type Work } from './pool'
import type { Tasks } from './tasks'

interface Parts {
  comparison: OpenComparison
  analyst: AnalystClient
  tasks: Tasks
  writer: ComparisonWriter
  /** How many runs were there already. */
  kept: number
  workers?: number | undefined
  /** Something has changed that is worth showing. */
  changed(): void
  /** Every run has ended: no more are to be done, or it was paused. */
  rested(): void
}

const now = () => performance.now() / 1000

export class Runner implements Work {
  readonly failures: Failure[] = []
  private readonly tasks: Tasks
  private order: number[]
  private readonly estimate: Estimate
  private pool: Pool | null = null
  private at = 0
  private halted = true
  private doneSoFar = 0

  constructor(private readonly parts: Parts) {
    this.tasks = parts.tasks
    this.order = this.tasks.inOrder(parts.comparison.firstSeeds)
    this.estimate = new Estimate(this.tasks, now())
    this.recount()
  }

  /** Only these tasks are to be done; null: all. */
  restrict(to: Iterable<number> | null): void {
    const wanted = to && new Set(to)
    const all = this.tasks.inOrder(this.parts.comparison.firstSeeds)
    this.order = wanted ? all.filter((index) => wanted.has(index)) : all
    this.at = 0
    this.recount()
  }

  /** After runs that were done elsewhere have been taken in, or taken away. */
  recount(): void {
    this.doneSoFar = this.order.filter((index) => this.parts.analyst.has(index)).length
  }

  get progress(): Progress {
    return {
      done: this.doneSoFar,
      total: this.order.length,
      kept: this.parts.kept,
      pathless: this.parts.analyst.pathless,
      failed: this.failures.length,
      secondsLeft: this.halted ? null : this.estimate.secondsLeft(this.left()),
    }
  }

  get isComplete(): boolean {
    return this.doneSoFar === this.order.length
  }

  /** Runs that are under way. */
  get inFlight(): number {
    return this.pool?.inFlight ?? 0
  }

  start(): void {
    this.halted = false
    // Failed runs are tried again; runs under way are not started twice.
    if (this.inFlight === 0) {
      this.at = 0
      this.failures.length = 0
    }
    this.estimate.resume(now())
    const { comparison, workers } = this.parts
    this.pool ??= new Pool(
      comparison.document,
      poolSize(this.order.length - this.doneSoFar, workers),
      this,
    )
    this.pool.start()
  }

  /** Starts no more runs; those under way are finished and kept. */
  halt(): void {
    this.halted = true
  }

  end(): void {
    this.halted = true
    this.pool?.terminate()
    this.pool = null
  }

  next(): number | null {
    if (this.halted) return null
    while (this.at < this.order.length) {
      const index = this.order[this.at++]
      if (index !== undefined && !this.parts.analyst.has(index)) return index
    }
    return null
  }

  done(run: KeptRun): void {
    const { analyst, writer, changed } = this.parts
    if (analyst.has(run.index)) return
    analyst.keep(run)
    writer.keep(run)
    this.doneSoFar += 1
    this.estimate.done(run.index, run.seconds.at(-1) ?? 0, now())
    changed()
  }

  failed(index: number, error: EngineError): void {
    this.failures.push({ index, what: this.whatOf(index), error })
    this.parts.changed()
  }

  rests(): void {
    this.parts.rested()
  }

  private whatOf(index: number): string {
    const entry = this.parts.comparison.question.entries[this.tasks.entryOf(index)]
    return `${translated(entry?.label ?? '')} · ${this.tasks.seedOf(index)}`
  }

  private *left(): Iterable<number> {
    for (const index of this.order) if (!this.parts.analyst.has(index)) yield index
  }
}
