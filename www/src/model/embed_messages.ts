/** What crosses between an embedded page and the page around it: docs/embedding.md has the table. */
import type { EngineError, Objective, ReportLanguage, ResultFile, Status } from '@pkg/formicarium'
import type { CompareOptions, LoadOptions, RunOptions, Scripting, Source } from './scripting'

/** The version of the messages, in their field `formicarium`. */
export const VERSION = 1

/** What each request may say: the names of `window.formicarium`, its arguments by name. */
export interface Requests {
  version: Record<never, never>
  load: { source: Source; options?: LoadOptions }
  run: { options?: RunOptions }
  pause: Record<never, never>
  look: { iteration: number | null }
  results: Record<never, never>
  session: Record<never, never>
  compare: { options?: CompareOptions }
  resultFile: { file: ResultFile; language?: ReportLanguage }
}
export type RequestKind = keyof Requests

/** The arguments in the order in which the call takes them. */
export const ARGUMENTS: { [K in RequestKind]: (keyof Requests[K] & string)[] } = {
  version: [],
  load: ['source', 'options'],
  run: ['options'],
  pause: [],
  look: ['iteration'],
  results: [],
  session: [],
  compare: ['options'],
  resultFile: ['file', 'language'],
}

/** What the answer to a request holds; null where the call gives nothing. */
export type Answer<K extends RequestKind> = Scripting[K] extends (...args: never[]) => infer R
  ? Awaited<R> extends undefined
    ? null
    : Awaited<R>
  : Scripting[K]

/** Where a panel's run stands. Panels are counted from 0 on, as in `results`. */
export interface RunMoment {
  panel: number
  planner: string
  iteration: number
  /** Of the best path; null while there is none. */
  length: number | null
  /** The same by what the planner is measured by. */
  value: number | null
  objective: Objective
}

/** What the embedded page tells by itself. */
export interface Events {
  /** It takes requests. `opened`: whether there is anything on show; a link that could not be read is not. */
  ready: { version: string; opened: boolean }
  'first-path': RunMoment
  'better-path': RunMoment
  end: RunMoment & { status: Status; digest: string }
  /** What is on show is another race now, or the same with other walls, planners or values. */
  session: { map: string; title: string; seed: number; planners: string[] }
}
export type EventName = keyof Events

export type Refusal = Pick<EngineError, 'kind' | 'message' | 'hint'> & { field: string }

type Tagged<T> = { formicarium: typeof VERSION } & T

/** What the embedded page sends. */
export type Sent =
  | Tagged<{ kind: 'answer'; id: string | number; value: unknown }>
  | Tagged<{ kind: 'error'; id: string | number | null; error: Refusal }>
  | { [E in EventName]: Tagged<{ kind: 'event'; event: E } & Events[E]> }[EventName]
  /** To a page that it does not know: it is here, and no more. */
  | Tagged<{ kind: 'event'; event: 'ready' }>
