/** Does runs on as many workers as the machine has processors. Each has its own engine; a run's result does not depend on its worker. */
import type { DoneRun, EngineError } from '@pkg/formicarium'
import { workerAt } from '../../engine/new_worker'
import { ToolBox } from '../../engine/tools'
import type { PoolCalls } from '../../model/comparison_calls'
import { toEngineError } from '../../model/errors'
import poolUrl from '../../worker/pool.worker?worker&url'

/** What a pool is to do, and whom it tells. */
export interface Work {
  /** The next run's number among the tasks; null when there is none, or none for now. */
  next(): number | null
  done(run: DoneRun): void
  /** The engine refuses the run, or has crashed twice over it. */
  failed(index: number, error: EngineError): void
  /** Every worker has come to rest. */
  rests(): void
}

/** Short runs are queued in pairs, so that a worker goes on while the page reads its answer. */
const SHORT_RUNS_AHEAD = 2
/** Longer runs are not queued: pausing must not wait for one that has not begun. */
const SHORT_SECONDS = 0.1
/** Memory runs out before processors do. */
export const MOST_WORKERS = 32

export function poolSize(runs: number, wanted = navigator.hardwareConcurrency || 2): number {
  return Math.max(1, Math.min(wanted, runs, MOST_WORKERS))
}

export class Pool {
  private readonly workers: PoolWorker[]
  /** Runs to be repeated because their worker has crashed. */
  private readonly again: number[] = []
  private readonly stopped = new Set<number>()

  constructor(
    document: string,
    size: number,
    private readonly work: Work,
  ) {
    this.workers = Array.from({ length: size }, () => new PoolWorker(document, this))
  }

  /** Runs that have begun or are next in line. */
  get inFlight(): number {
    return this.workers.reduce((sum, worker) => sum + worker.inFlight, 0)
  }

  /** Every worker takes runs until there are no more. */
  start(): void {
    for (const worker of this.workers) worker.takeUp()
    if (this.inFlight === 0) this.work.rests()
  }

  /** Ends at once; what has not been finished is lost. */
  terminate(): void {
    for (const worker of this.workers) worker.terminate()
  }

  next(): number | null {
    return this.again.shift() ?? this.work.next()
  }

  done(run: DoneRun): void {
    this.work.done(run)
  }

  rests(): void {
    if (this.again.length > 0) this.start()
    else if (this.inFlight === 0) this.work.rests()
  }

  failed(index: number, error: EngineError): void {
    this.work.failed(index, error)
  }

  /** The first run was under way when its worker crashed; the others were waiting. */
  crashed([first, ...waiting]: number[], error: EngineError): void {
    this.again.push(...waiting)
    if (first === undefined) return
    if (this.stopped.has(first)) this.failed(first, error)
    else {
      this.stopped.add(first)
      this.again.push(first)
    }
  }
}

/** One worker and its queue of runs. */
class PoolWorker {
  private box: ToolBox<PoolCalls> | null = null
  private assigned: number[] = []
  private longest = 0
  private ended = false

  constructor(
    private readonly document: string,
    private readonly pool: Pool,
  ) {}

  get inFlight(): number {
    return this.assigned.length
  }

  takeUp(): void {
    if (this.ended) return
    const ahead = this.longest > SHORT_SECONDS ? 1 : SHORT_RUNS_AHEAD
    while (this.assigned.length < ahead) {
      const index = this.pool.next()
      if (index === null) return
      this.assigned.push(index)
      void this.run(index)
    }
  }

  terminate(): void {
    this.ended = true
    this.assigned = []
    this.box?.terminate()
  }

  private async run(index: number): Promise<void> {
    const box = this.worker()
    try {
      const run = await box.call('run', index)
      if (this.ended) return
      this.longest = Math.max(this.longest, run.seconds.at(-1) ?? 0)
      this.assigned = this.assigned.filter((other) => other !== index)
      this.pool.done(run)
    } catch (thrown) {
      // When a worker has been replaced, its first run has reported for the others.
      if (this.ended || box !== this.box || !this.assigned.includes(index)) return
      this.giveUp(index, toEngineError(thrown), box)
    }
    this.takeUp()
    if (this.assigned.length === 0) this.pool.rests()
  }

  private giveUp(index: number, error: EngineError, box: ToolBox<PoolCalls>): void {
    if (box.dead) {
      const lost = this.assigned
      this.assigned = []
      this.pool.crashed(lost, error)
    } else {
      this.assigned = this.assigned.filter((other) => other !== index)
      this.pool.failed(index, error)
    }
  }

  /** After a trap the instance's memory cannot be trusted: the next run gets a fresh worker. */
  private worker(): ToolBox<PoolCalls> {
    if (this.box === null || this.box.dead) {
      this.box = new ToolBox<PoolCalls>('whole', workerAt(poolUrl))
      // A document that cannot be opened makes its runs fail, one by one.
      this.box.call('open', this.document).catch(() => {})
    }
    return this.box
  }
}
