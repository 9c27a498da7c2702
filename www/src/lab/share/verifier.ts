/**
 * Repeats runs of others to compare them with what was recorded, which stays as it is: those of a file, or a sample of those that a class
 * has brought. A link has no runs, so its runs are simply done.
 */
import { signal } from '@preact/signals'
import type { KeptRun } from '../../model/comparison_calls'
import { notifyError } from '../../state'
import { checkRun, compareAgain, openComparison, runsInOrder } from '../run/actions'
import { Pool, poolSize, type Work } from '../run/pool'
import { drawSample } from '../run/sample'
import { broughtRuns, type PlacedRun, placedRun } from '../run/shares'

/** A repeated run that came out otherwise. */
export interface ForgedRun extends PlacedRun {
  index: number
  /** The row that came out here. */
  came: string
}

export interface Verifying {
  /** Of the runs in a file, or a sample of those that files of a class have brought. */
  of: 'file' | 'class'
  done: number
  total: number
  /** Runs that could not be done. */
  failed: number
  /** Those that came out otherwise, in the order in which they were repeated. */
  forged: ForgedRun[]
  isRunning: boolean
}

/** Progress of the repeated runs; null until the reader asks for them. */
export const verifying = signal<Verifying | null>(null)

const COMPARE_MS = 500

let job: Job | null = null

/** Repeats the first `seeds` seeds of each entry on each map; null: all. */
export function verifyAgain(seeds: number | null): void {
  const now = openComparison.peek()
  if (!now) return
  stopVerifying()
  job = new Job('file', now.id, now.document, runsInOrder(seeds))
}

/** Repeats a part, from 0 to 1, of the runs that files have brought, drawn by chance, at least one of each file. */
export function verifySample(part: number): void {
  const now = openComparison.peek()
  if (!now) return
  stopVerifying()
  job = new Job('class', now.id, now.document, drawSample(broughtRuns(), part))
}

export function stopVerifying(): void {
  job?.end()
  job = null
}

/** For when another comparison has been opened. */
export function forgetVerifying(): void {
  stopVerifying()
  verifying.value = null
}

class Job implements Work {
  private readonly pool: Pool
  private at = 0
  private done_ = 0
  private failed_ = 0
  private readonly forged: ForgedRun[] = []
  private ended = false
  private timer = 0

  constructor(
    private readonly of: Verifying['of'],
    private readonly comparison: string,
    document: string,
    private readonly order: number[],
  ) {
    this.pool = new Pool(document, poolSize(order.length), this)
    this.show()
    this.pool.start()
  }

  end(): void {
    this.ended = true
    this.pool.terminate()
    clearTimeout(this.timer)
    this.show()
    void this.compare()
  }

  next(): number | null {
    return this.ended ? null : (this.order[this.at++] ?? null)
  }

  done(run: KeptRun): void {
    if (this.comparison !== openComparison.peek()?.id) {
      this.end()
      return
    }
    this.done_ += 1
    checkRun(run)
    const recorded = placedRun(run.index)
    if (recorded && recorded.row !== run.row)
      this.forged.push({ ...recorded, index: run.index, came: run.row })
    this.show()
    if (this.timer === 0) this.timer = window.setTimeout(() => void this.compare(), COMPARE_MS)
  }

  failed(_: number, error: unknown): void {
    this.failed_ += 1
    if (this.failed_ === 1) notifyError(error)
    this.show()
  }

  rests(): void {
    this.end()
  }

  private async compare(): Promise<void> {
    try {
      await compareAgain()
    } catch (error) {
      notifyError(error)
    }
    this.timer = 0
  }

  private show(): void {
    if (this.comparison !== openComparison.peek()?.id) return
    verifying.value = {
      of: this.of,
      done: this.done_,
      total: this.order.length,
      failed: this.failed_,
      forged: [...this.forged],
      isRunning: !this.ended,
    }
  }
}
