/** The open experiment at work: which runs are to be done, who does them, what has come of them. */
import type { EngineError } from '@pkg/formicarium'
import { translated } from '../../i18n'
import type { KeptRun } from '../../model/comparison_calls'
import type { Keeper } from '../store/shelf'
import type { Failure, Progress, Study } from '../store/signals'
import type { Desk } from './desk'
import { Estimate } from './estimate'
import { Pool, poolSize, type Work } from './pool'
import { Tasks } from './tasks'

interface Parts {
  study: Study
  desk: Desk
  keeper: Keeper
  /** Runs that are there already. */
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
  readonly tasks: Tasks
  private readonly order: number[]
  private readonly estimate: Estimate
  private pool: Pool | null = null
  private at = 0
  private halted = true
  private doneSoFar = 0

  constructor(private readonly parts: Parts) {
    const { question, firstSeeds } = parts.study
    this.tasks = new Tasks(question)
    this.order = this.tasks.inOrder(firstSeeds ?? undefined)
    this.estimate = new Estimate(this.tasks, now())
    this.recount()
  }

  /** After runs have been taken in that others have done. */
  recount(): void {
    this.doneSoFar = this.order.filter((index) => this.parts.desk.has(index)).length
  }

  get progress(): Progress {
    return {
      done: this.doneSoFar,
      total: this.order.length,
      kept: this.parts.kept,
      pathless: this.parts.desk.pathless,
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
    // Those that could not be done are tried again, those under way are not begun twice.
    if (this.inFlight === 0) {
      this.at = 0
      this.failures.length = 0
    }
    this.estimate.resume(now())
    const { study, workers } = this.parts
    this.pool ??= new Pool(
      study.document,
      poolSize(this.order.length - this.doneSoFar, workers),
      this,
    )
    this.pool.start()
  }

  /** Runs that are under way are finished and kept. */
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
      if (index !== undefined && !this.parts.desk.has(index)) return index
    }
    return null
  }

  done(run: KeptRun): void {
    const { desk, keeper, changed } = this.parts
    if (desk.has(run.index)) return
    desk.keep(run)
    keeper.keep(run)
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
    const { entries, seeds } = this.parts.study.question
    const able = entries.filter(({ planner }) => planner != null)
    const entry = able[this.tasks.pairOf(index) % able.length]
    return `${translated(entry?.label ?? '')} · ${seeds.from + this.tasks.seedOf(index)}`
  }

  private *left(): Iterable<number> {
    for (const index of this.order) if (!this.parts.desk.has(index)) yield index
  }
}
