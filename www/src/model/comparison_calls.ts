/** What the workers of a comparison can do: the analyst keeps its runs, the pool does them. */
import type { Axis, DoneRun, ResultFile, Verification } from '@pkg/formicarium'
import type { Analysis } from './analysis'

/** A run that is done, as it is kept. */
export type KeptRun = DoneRun

export interface AnalystCalls {
  /** Takes up a document; the runs in it come back, and are kept. */
  open(document: string): { tasks: number; rows: KeptRun[]; engine: string }
  keep(runs: KeptRun[]): void
  /** Runs that were done again, only to be compared with those that the document brought. */
  check(runs: KeptRun[]): void
  /** Intervals take longer: for runs at rest. */
  analysis(axis: Axis, intervals: boolean): Analysis
  file(kind: ResultFile, command: string): string
  verify(): Verification | null
}

export interface PoolCalls {
  open(document: string): void
  run(index: number): DoneRun
}
