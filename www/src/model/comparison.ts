/** A comparison as a document (`formicarium/comparison@1`, docs/formats.md), as far as the page reads it. */
import type { Axis, ScenarioSpec } from '@pkg/formicarium'
import type { ParamValues } from './messages'

export const QUESTION_FORMAT = 'formicarium/question@1'
export const RESULT_FORMAT = 'formicarium/comparison@1'

export interface Budget {
  axis: Exclude<Axis, 'time'>
  amount: number
}

export interface Instance {
  /** Small letters, digits, `-`. */
  id: string
  map: string
  note?: string
}

export interface Entry {
  /** Small letters, digits, `-`. */
  id: string
  label: string
  role: 'baseline' | 'improved' | 'other'
  planner?: string | null
  missing?: string | null
  /** The file that its imported results come from. */
  results?: string | null
  preset?: string | null
  set?: ParamValues
  published?: Record<string, Record<string, number | null>>
}

export interface Question {
  format: typeof QUESTION_FORMAT
  title: string
  paper?: string
  asks: string
  seeds: { from: number; count: number }
  budget?: Budget
  instances: Instance[]
  entries: Entry[]
  claims?: Claim[]
}

export interface Claim {
  id: string
  says: string
  /** What a reader of the verdict must know. */
  note?: string
}

/** A map of the question: `formicarium/scenario@1`. */
export type MapOfQuestion = ScenarioSpec & Record<string, unknown>

export interface ComparisonDocument {
  format: typeof RESULT_FORMAT
  question: Question
  maps: MapOfQuestion[]
  recorded?: { engine: string; experiment: string }
  /** Imported results. */
  given?: unknown[]
  rows?: unknown[]
}

export const textOf = (document: ComparisonDocument): string => JSON.stringify(document)

/** Of a document that the engine has accepted. */
export const documentOf = (text: string): ComparisonDocument =>
  JSON.parse(text) as ComparisonDocument

/** The entries that can be run; the others have imported results, or none. */
export const runnable = ({ entries }: Question): Entry[] =>
  entries.filter(({ planner }) => planner != null)

export function countRuns(question: Question): number {
  return question.instances.length * runnable(question).length * question.seeds.count
}
