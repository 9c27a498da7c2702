/** Runs on as many workers as the machine has processors, each with an engine of its own: which one does a run changes nothing. */
import type { DoneRun, EngineError } from '@pkg/formicarium'
import { ToolBox } from '../../engine/tools'
import type { PoolCalls } from '../../model/comparison_calls'
import { toEngineError } from '../../model/errors'
import PoolWorker from '../../worker/pool.worker?worker'

/** What a pool is to do, and whom it tells. */
export interface Work {
  /** The next run's place among the tasks; null: there is no more, or not now. */
  next(): number | null
  done(run: DoneRun): void
  /** It cannot be done: the engine refuses it, or has stopped twice over it. */
  failed(index: number, error: EngineError): void
  /** Every worker has come to rest. */
  rests(): void
}

/** A worker that answers goes on with the next run at once, while the page still reads the answer. */
const SHORT_RUNS_AHEAD = 2
/** Longer runs wait for nobody, and pausing must not wait for one that has not begun. */
const SHORT_SECONDS = 0.1
/** Memory, more than processors, is what runs out. */
const MOST_WORKERS = 32

export function poolSize(runs: number, wanted = navigator.hardwareConcurrency || 2): number {
  return Math.max(1, Math.min(wanted, runs, MOST_WORKERS))
}

export class Pool {
  private readonly hands: Hand[]
  /** Runs that are to be repeated, because their worker has stopped. */
  private readonly again: number[] = []
  private readonly stopped = new Set<number>()

  constructor(
    document: string,
    size: number,
    private readonly work: Work,
  ) {
    this.hands = Array.from({ length: size }, () => new Hand(document, this))
  }

  /** Runs that have begun or are next in line. */
  get inFlight(): number {
    return this.hands.reduce((sum, hand) => sum + hand.inFlight, 0)
  }

  /** Every worker takes runs until there are no more. */
  start(): void {
    for (const hand of this.hands) hand.takeUp()
    if (this.inFlight === 0) this.work.rests()
  }

  /** Ends at once; what has not been finished is lost. */
  terminate(): void {
    for (const hand of this.hands) hand.terminate()
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

  /** The first one was at work when its worker stopped; the others only waited. */
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

/** One worker and the runs it has been given, first come, first done. */
class Hand {
  private box: ToolBox<PoolCalls> | null = null
  private given: number[] = []
  private longest = 0
  private ended = false

  constructor(
    private readonly document: string,
    private readonly pool: Pool,
  ) {}

  get inFlight(): number {
    return this.given.length
  }

  takeUp(): void {
    if (this.ended) return
    const ahead = this.longest > SHORT_SECONDS ? 1 : SHORT_RUNS_AHEAD
    while (this.given.length < ahead) {
      const index = this.pool.next()
      if (index === null) return
      this.given.push(index)
      void this.run(index)
    }
  }

  terminate(): void {
    this.ended = true
    this.given = []
    this.box?.terminate()
  }

  private async run(index: number): Promise<void> {
    const box = this.worker()
    try {
      const run = await box.call('run', index)
      if (this.ended) return
      this.longest = Math.max(this.longest, run.seconds.at(-1) ?? 0)
      this.given = this.given.filter((other) => other !== index)
      this.pool.done(run)
    } catch (thrown) {
      // Of a worker that has been replaced, the first run to hear of it has told for all.
      if (this.ended || box !== this.box || !this.given.includes(index)) return
      this.giveUp(index, toEngineError(thrown), box)
    }
    this.takeUp()
    if (this.given.length === 0) this.pool.rests()
  }

  private giveUp(index: number, error: EngineError, box: ToolBox<PoolCalls>): void {
    if (box.dead) {
      const lost = this.given
      this.given = []
      this.pool.crashed(lost, error)
    } else {
      this.given = this.given.filter((other) => other !== index)
      this.pool.failed(index, error)
    }
  }

  /** After a trap the instance's memory cannot be trusted: the next run gets a fresh worker. */
  private worker(): ToolBox<PoolCalls> {
    if (this.box === null || this.box.dead) {
      this.box = new ToolBox<PoolCalls>('whole', new PoolWorker())
      // A document that cannot be opened makes its runs fail, one by one.
      this.box.call('open', this.document).catch(() => {})
    }
    return this.box
  }
}
