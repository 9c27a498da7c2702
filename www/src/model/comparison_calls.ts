/** What the workers of a comparison can do: the analyst keeps its runs, the pool does them. */
import type {
  Axis,
  ComparisonOutline,
  DoneRun,
  ReportLanguage,
  ResultFile,
  Verification,
} from '@pkg/formicarium'
import type { Analysis } from './analysis'

/** A run that is done, as it is kept. */
export type KeptRun = DoneRun

/** What the engine tells of a document before anything has run. */
export interface Opened {
  outline: ComparisonOutline
  /** Every task in its place, three numbers each: instance and entry as places in the question, and the seed. */
  tasks: Uint32Array
  /** The places of all tasks in the order in which they are handed out, seed by seed. */
  order: Uint32Array
  /** The runs that the document has brought along. */
  rows: KeptRun[]
}

export interface AnalystCalls {
  /** Takes up a document and keeps the runs in it. */
  open(document: string): Opened
  keep(runs: KeptRun[]): void
  /** Runs that were done again, only to be compared with those that the document brought. */
  check(runs: KeptRun[]): void
  /** Intervals take longer: for runs at rest. */
  analysis(axis: Axis, intervals: boolean): Analysis
  /** `language`: of what people read. */
  file(kind: ResultFile, command: string, language: ReportLanguage): string
  verify(): Verification | null
}

export interface PoolCalls {
  open(document: string): void
  run(index: number): DoneRun
}
