/**
 * `window.formicarium`: what lessons, tests and the console may ask of the page. docs/scripting.md describes it.
 *
 *     await formicarium.load(link)             // a share link, the text of any file we read, a session, a File, Files
 *     await formicarium.run()                  // to the end of every panel, or a stop; or { iterations: 20, stops: 'ignore' }
 *     formicarium.results()                    // one entry a panel
 *     await formicarium.look(12)               // all panels as they stood after iteration 12; null for now
 *     await formicarium.compare({ seeds: 30 }) // map and planners over many seeds; the result files as text
 */
import type { ReportLanguage, ResultFile, RunSummary } from '@pkg/formicarium'
import type { CompareOptions, ComparisonResult } from '../lab/scripting'
import type { Stop } from '../model/lesson'
import type { Session } from '../model/session'
import { placeOf } from '../model/world'
import {
  currentSession,
  engineVersion,
  historyOf,
  type Panel,
  type PanelLive,
  panels,
  pause,
  scenario,
  stopsMet,
} from '../state'
import { latest } from '../state/live_reports'
import type { LoadOptions, Source } from '../state/script_files'

export interface PanelResult {
  planner: string
  params: Session['panels'][number]['params']
  summary: RunSummary | null
  /** Best path as [x, y] cells; null when none was found. */
  path: [number, number][] | null
  /** On a terrain the altitude of each of its cells in metres; null elsewhere. */
  altitudes: number[] | null
  /** On a map whose place in the world is known, the middle of each of its cells as [x, y] in metres; null elsewhere. */
  world: [number, number][] | null
  /** One row an iteration: iteration, best so far, iteration best, mean, worst, arrived. */
  history: number[][]
  verified: PanelLive['verified']
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
  notices: { kind: string; message: string }[]
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

declare global {
  interface Window {
    formicarium: Scripting
  }
}

const calls = () => import('./script_calls')

export function offerScripting(): void {
  window.formicarium = {
    get version() {
      return engineVersion.peek()
    },
    load: async (source, options) => (await calls()).load(source, options),
    async run(options) {
      await (await calls()).run(options)
      return results()
    },
    pause,
    async look(iteration) {
      await (await calls()).look(iteration)
      return results()
    },
    results,
    session: currentSession,
    compare: async (options) => (await calls()).compare(options),
    resultFile: async (kind, language) => (await calls()).resultFile(kind, language),
  }
}

function results(): PanelResult[] {
  const spec = scenario.peek()?.spec
  return panels.peek().map((panel) => {
    const live = panel.past.peek() ?? latest(panel.id)
    const { planner, params } = panel.setup
    const { summary, verified } = live
    const path = pairs(live.bestPath)
    return {
      planner,
      params,
      summary,
      path,
      world: spec?.world && path ? path.flatMap((cell) => [placeOf(spec, cell) ?? cell]) : null,
      altitudes: live.bestAltitudes?.length ? [...live.bestAltitudes] : null,
      history: rows(panel),
      verified,
      error: errorOf(live),
      stops: stopsMet.peek().flatMap((met) => (met.panelId === panel.id ? [met.stop] : [])),
    }
  })
}

function errorOf({ error, crashed }: PanelLive): PanelResult['error'] {
  const told = crashed ?? error
  return told && { kind: told.kind, message: told.message }
}

function rows(panel: Panel): number[][] {
  const flat = historyOf(panel.id).toArray()
  return Array.from({ length: flat.length / 6 }, (_, i) => [...flat.subarray(i * 6, i * 6 + 6)])
}

function pairs(flat: Uint32Array | null): [number, number][] | null {
  if (!flat || flat.length === 0) return null
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i] ?? 0, flat[2 * i + 1] ?? 0])
}
