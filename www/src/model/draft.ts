/** A comparison that is being put together. */
import type { AblationRole, Budget, ResultsMatch } from '@pkg/formicarium'
import type { ParamValues } from './messages'
import type { Scenario } from './session'

export interface DraftMap {
  key: number
  name: string
  scenario: Scenario
}

export interface DraftEntry {
  key: number
  planner: string
  preset: string | null
  /** Only the values that differ from the catalog's defaults. */
  params: ParamValues
  /** As the reader wrote it; null: by its planner. */
  label: string | null
  /** Of an ablation: which entry it is. */
  id: string | null
  /** What it is in an ablation; null where it has no part in one. */
  ablation: AblationRole | null
}

/** What fills a new one. */
export interface Filling {
  maps: Omit<DraftMap, 'key'>[]
  entries: Omit<DraftEntry, 'key'>[]
  seeds: { from: number; count: number }
  budget: Budget | null
  ablated: string | null
  untilBudget?: boolean
  title?: string | null
  /** What the reader says of it. */
  note?: string
}

/** A file of imported results that belongs to it. */
export interface ImportedFile {
  key: number
  name: string
  bytes: Uint8Array
  /** Id of the map on which the runs are, where the file does not say. */
  instance: string | null
  /** Names of maps in the file whose runs are left out: the comparison has no such map. */
  leaveOut: string[]
  /** Whose runs it holds, and on which maps; null in a draft that was kept before this was told. */
  match: ResultsMatch | null
}

/** Everything of it, as the browser keeps it. */
export interface StoredDraft extends Filling {
  files: ImportedFile[]
  /** Milliseconds since 1970. */
  changed: number
}
