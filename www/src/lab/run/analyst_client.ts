/** The page's side of the analyst, the worker that analyses runs. Asks often enough to watch, and leaves the worker time for runs. */
import type {
  EngineError,
  FrontQuestion,
  MapFronts,
  ReportLanguage,
  ResultFile,
  TakenJournal,
  Verification,
} from '@pkg/formicarium'
import type { Analysis } from '../../model/analysis'
import type { KeptRun, Opened } from '../../model/comparison_calls'
import { toEngineError } from '../../model/errors'
import { axis } from '../store/signals'
import { type Analyst, newAnalyst } from './analyst'

/** Between two looks while runs go on. */
const LOOK_MS = 1000
/** Looks take at most this share of the analyst's time. */
const MOST_OF_TIME = 1 / 10

export interface Look {
  analysis: Analysis
  verification: Verification | null
}

export class AnalystClient {
  private readonly runs = new Map<number, KeptRun>()
  private unsent: KeptRun[] = []
  /** Repeated runs, only to be compared with the recorded ones. */
  private readonly again = new Map<number, KeptRun>()
  private unchecked: KeptRun[] = []
  private analyst: Analyst | null = null
  private timer = 0
  private notBefore = 0
  private asked = 0

  constructor(
    private readonly document: string,
    private readonly tell: (look: Look) => void,
    private readonly trouble: (error: EngineError) => void,
  ) {}

  /** Opens the document. Throws what the engine refuses. */
  async open(): Promise<Opened> {
    const opened = await this.called().call('open', this.document)
    for (const run of opened.rows) this.runs.set(run.index, run)
    return opened
  }

  keep(run: KeptRun): void {
    this.runs.set(run.index, run)
    this.unsent.push(run)
  }

  check(run: KeptRun): void {
    this.again.set(run.index, run)
    this.unchecked.push(run)
  }

  get all(): KeptRun[] {
    return [...this.runs.values()]
  }

  get(index: number): KeptRun | undefined {
    return this.runs.get(index)
  }

  has(index: number): boolean {
    return this.runs.has(index)
  }

  /** How many runs are done. */
  get count(): number {
    return this.runs.size
  }

  /** Every run that is done. */
  kept(): Iterable<KeptRun> {
    return this.runs.values()
  }

  get pathless(): number {
    let count = 0
    for (const { found } of this.runs.values()) if (!found) count += 1
    return count
  }

  /** Looks soon, but not right after another look. */
  lookSoon(): void {
    if (this.timer !== 0) return
    const wait = Math.max(LOOK_MS, this.notBefore - performance.now())
    this.timer = window.setTimeout(() => void this.look(false), wait)
  }

  /** Looks now. `settled`: no runs are under way, so intervals are computed as well. */
  async look(settled: boolean): Promise<void> {
    clearTimeout(this.timer)
    this.timer = 0
    const turn = ++this.asked
    const began = performance.now()
    try {
      const found = await this.call((analyst) => analyst.call('analysis', axis.peek(), settled))
      const verification = await this.call((analyst) => analyst.call('verify'))
      // The answer to a newer look counts.
      if (turn === this.asked) this.tell({ analysis: found, verification })
    } catch (thrown) {
      if (turn === this.asked) this.trouble(toEngineError(thrown))
    }
    const took = performance.now() - began
    this.notBefore = performance.now() + took * (1 / MOST_OF_TIME - 1)
  }

  /** How far the runs agree with what was recorded. */
  verify(): Promise<Verification | null> {
    return this.call((analyst) => analyst.call('verify'))
  }

  file(
    kind: ResultFile,
    command: string,
    language: ReportLanguage,
    fronts?: FrontQuestion,
  ): Promise<string> {
    return this.call((analyst) => analyst.call('file', kind, command, language, fronts))
  }

  fronts(asked: FrontQuestion): Promise<MapFronts[]> {
    return this.call((analyst) => analyst.call('fronts', asked))
  }

  /** The places of a share's tasks. Throws where there is no such share. */
  dealt(share: string): Promise<Uint32Array> {
    return this.call((analyst) => analyst.call('dealt', share))
  }

  /** Of each task the number of its share. */
  shares(of: number): Promise<Uint32Array> {
    return this.call((analyst) => analyst.call('shares', of))
  }

  journal(share: string): Promise<{ name: string; text: string }> {
    return this.call((analyst) => analyst.call('journal', share))
  }

  /** Takes in the runs of a file; `from`: its key. A run that was done here meanwhile stays. */
  async takeJournal(text: string, from: number): Promise<TakenJournal> {
    const taken = await this.call((analyst) => analyst.call('takeJournal', text))
    const runs = taken.runs.filter(({ index }) => !this.runs.has(index))
    for (const run of runs) this.runs.set(run.index, { ...run, from })
    return { ...taken, runs }
  }

  /** Lets go of runs, as if they had never been done. */
  async forget(indices: number[]): Promise<void> {
    for (const index of indices) {
      this.runs.delete(index)
      this.again.delete(index)
    }
    await this.call((analyst) => analyst.call('forget', indices))
  }

  /** What the runs say now, without intervals. */
  analysis(): Promise<Analysis> {
    return this.call((analyst) => analyst.call('analysis', axis.peek(), false))
  }

  close(): void {
    clearTimeout(this.timer)
    this.asked += 1
    this.analyst?.terminate()
  }

  /** Asks once the analyst has all runs. */
  private async call<T>(ask: (analyst: Analyst) => Promise<T>): Promise<T> {
    const analyst = this.called()
    const runs = this.unsent
    this.unsent = []
    if (runs.length > 0) await analyst.call('keep', runs)
    const again = this.unchecked
    this.unchecked = []
    if (again.length > 0) await analyst.call('check', again)
    return ask(analyst)
  }

  /** The analyst. One that has stopped is replaced by a new one, which gets all runs. */
  private called(): Analyst {
    if (this.analyst && !this.analyst.dead) return this.analyst
    const isFirst = this.analyst === null
    this.analyst = newAnalyst()
    if (!isFirst) {
      this.analyst.call('open', this.document).catch(() => {})
      this.unsent = [...this.runs.values()]
      this.unchecked = [...this.again.values()]
    }
    return this.analyst
  }
}
