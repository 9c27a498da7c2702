/** The worker that keeps all runs of the open experiment. */
import type { Axis, DoneRun, ResultFile, Verification } from '@pkg/formicarium'
import { ToolBox } from '../engine/tools'
import AnalystWorker from './analyst.worker?worker'
import type { Analysis } from './results/types'

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

export type Analyst = ToolBox<AnalystCalls>

export const newAnalyst = (): Analyst => new ToolBox<AnalystCalls>('whole', new AnalystWorker())
