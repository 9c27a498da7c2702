/**
 * What scripts and pages around this one may ask of it, and what they are told: the types of `window.formicarium`, of the messages of
 * an embedded page, and of the custom element.
 */
import type {
  Budget,
  Notice,
  ReadOptions,
  ReportLanguage,
  ResultFile,
  RunSummary,
} from '@pkg/formicarium'
import type { Stop } from './lesson'
import type { ParamValues } from './messages'
import type { Caption, Look, PanelSetup, Session } from './session'
import type { TerrainPart } from './tool_calls'

export type Verification = 'none' | 'pending' | 'verified' | 'differs'

export interface PanelResult {
  planner: string
  params: ParamValues
  summary: RunSummary | null
  /** Best path as [x, y] cells; null when none was found. */
  path: [number, number][] | null
  /** On a terrain the altitude of each of its cells in metres; null elsewhere. */
  altitudes: number[] | null
  /** On a map whose place in the world is known, the middle of each of its cells as [x, y] in metres; null elsewhere. */
  world: [number, number][] | null
  /** One row an iteration: iteration, best so far, iteration best, mean, worst, arrived. */
  history: number[][]
  verified: Verification
  /** Why there is no run, or no more of it: the engine refused it, or it has failed; null as a rule. */
  error: { kind: string; message: string } | null
  /** The stops that it has met where the runs stand now, e.g. `[{ when: 'first-path' }]`; empty while they stand for another reason. */
  stops: Stop[]
}

export interface RunOptions {
  /** So many of each panel; to its end, if nothing is said. */
  iterations?: number
  /** `hold`, if nothing is said: the runs go no further than to the first stop of the session. `ignore`: as if there were none. */
  stops?: 'hold' | 'ignore'
}

/** What `load` has opened. */
export interface Opened {
  /** `ends`: start and goal for the map on show. */
  kind: 'session' | 'map' | 'ends' | 'comparison' | 'results' | 'order'
  name: string
  /** What was assumed or left out on reading, in English. */
  notices: Pick<Notice, 'kind' | 'message'>[]
}

/** A session without what older scripts do not know of: title, note, labels, what was looked at. */
export type GivenSession = Omit<Session, 'panels' | keyof (Caption & Look)> &
  Partial<Caption & Look> & {
    panels: (Omit<PanelSetup, 'label'> & Partial<Pick<PanelSetup, 'label'>>)[]
  }

/** A link or the text of a file, a session, a file, or files that came together. */
export type Source = string | GivenSession | Blob | readonly Blob[] | FileList

export interface LoadOptions {
  /** Of several that could be opened, the one of this name. */
  file?: string
  /** Of a `.scen`, the line that says start and goal, counted from 1 as in the file. */
  row?: number
  /** How a picture, a robot's map or a text with several matrices is read; see the engine's `ReadOptions`. */
  read?: ReadOptions
  /** Of a raster of heights: a part, or fewer cells; `{}` is all of it. */
  part?: TerrainPart
  /** Of results: the map on which the runs are, and maps of the file that are left out. */
  instance?: string
  leaveOut?: string[]
  /** Whether everything that is left open is read as the page proposes it. */
  usual?: boolean
}

export interface ScriptedPlanner {
  /** Its id in the catalog. */
  planner: string
  /** A paper's values, by name. */
  preset?: string | null
  /** Values that differ from the defaults, or from the preset's. */
  params?: ParamValues
  /** What it is called in tables; by its planner, if nothing is said. */
  label?: string
}

/** A map of the gallery by its id, whatever `load` takes, or that with the options of `load`. */
export type ScriptedMap = Source | ({ source: Source } & LoadOptions)

export interface Asked {
  /** Those that race, if nothing is said. */
  planners?: (string | ScriptedPlanner)[]
  /** The one on show, if nothing is said. */
  maps?: ScriptedMap[]
  /** Of each planner: how many from 1 on, or which; 30 if nothing is said. */
  seeds?: number | { from: number; count: number }
  /** Of each run; none, if nothing is said. */
  budget?: Budget | null
  /** Whether every planner runs until the budget is spent, whatever its own parameters say. */
  untilBudget?: boolean
  title?: string
}

export interface CompareOptions extends Asked {
  /** A `formicarium/comparison@1` document, as text, which says everything; instead of all options above. */
  document?: string
  /** As many as the machine has processors, if nothing is said. */
  workers?: number
  /** How the Markdown file says that it was made; how the same comes from the command line, if nothing is said. */
  command?: string
}

export interface ComparisonResult {
  /** Runs that are done, those of them without a path, and runs that could not be done. */
  runs: number
  pathless: number
  failed: number
  /** Runs to be done altogether. More than `runs` and `failed` where the reader paused it. */
  total: number
  /** From the first run's beginning to the last one's end. */
  seconds: number
  /** The result files, as the command line writes them; `resultFile` gives all others. */
  files: Record<'csv' | 'markdown' | 'tests' | 'json', string>
}

/** Described in docs/scripting.md. What a promise is rejected with is an Error with `kind`, `field`, `message` and `hint`. */
export interface Scripting {
  readonly version: string
  /** Opens a link, the text of any file that can be read, a session, a file, or files that belong together. */
  load(source: Source, options?: LoadOptions): Promise<Opened>
  /** Runs every panel to its end, for a number of iterations, or to a stop, and gives the results. */
  run(options?: RunOptions): Promise<PanelResult[]>
  pause(): void
  /** Looks back at an iteration in every panel; null returns to the present. Meanwhile `results` tells of that iteration. */
  look(iteration: number | null): Promise<PanelResult[]>
  results(): PanelResult[]
  session(): Session | null
  /** Runs planners on maps with many seeds, or any comparison that a document holds. */
  compare(options?: CompareOptions): Promise<ComparisonResult>
  /** A result file of the comparison that is open, as text; what people read is in English, or in this language. */
  resultFile(kind: ResultFile, language?: ReportLanguage): Promise<string>
}
