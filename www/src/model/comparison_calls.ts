/** What the workers of a comparison can do: the analyst keeps its runs, the pool does them. */
import type {
  Axis,
  ComparisonOutline,
  DoneRun,
  FrontQuestion,
  MapFronts,
  ReportLanguage,
  ResultFile,
  TakenJournal,
  Verification,
} from '@pkg/formicarium'
import type { Analysis } from './analysis'

/** A run that is done, as it is kept. */
export interface KeptRun extends DoneRun {
  /** The key of the file that has brought it; left out where none has. */
  from?: number
}

/** What the engine tells of a document before anything has run. */
export interface Opened {
  /** Over question and maps: journals name it. */
  digest: string
  /** Most shares that it can be dealt to. */
  mostShares: number
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
  /** What the runs trade off, on each map. */
  fronts(asked: FrontQuestion): MapFronts[]
  /** `language`: of what people read; `fronts`: what files of fronts trade off. */
  file(kind: ResultFile, command: string, language: ReportLanguage, fronts?: FrontQuestion): string
  verify(): Verification | null
  /** The places of the tasks of a share, `I/N`. */
  dealt(share: string): Uint32Array
  /** Of each task the number of its share, where there are so many of them. */
  shares(of: number): Uint32Array
  /** The journal of a share's runs, and what its file is called after the comparison's own name. */
  journal(share: string): { name: string; text: string }
  takeJournal(text: string): TakenJournal
  /** The digest of the comparison whose runs a journal has; null where it does not tell. Needs no document. */
  digestIn(journal: Uint8Array): string | null
  /** Lets go of runs, by their places. */
  forget(indices: number[]): void
}

export interface PoolCalls {
  open(document: string): void
  run(index: number): DoneRun
}
