/**
 * `window.formicarium`: what lessons, tests and the console may ask of the page.
 *
 *     await formicarium.load(link)             // a share link, the text of any file we read, or a Session
 *     await formicarium.run()                  // to the end of every panel; or { iterations: 20 }
 *     formicarium.results()                    // one entry a panel
 *     await formicarium.look(12)               // all panels as they stood after iteration 12; null for now
 *     await formicarium.compare({ seeds: 30 }) // map and planners over many seeds; the result files as text
 */
import type { ResultFile, RunSummary } from '@pkg/formicarium'
import type { CompareOptions, ComparisonResult } from '../lab/scripting'
import type { Session } from '../model/session'
import { placeOf } from '../model/world'
import {
  currentSession,
  engineVersion,
  historyOf,
  importText,
  loadSession,
  type Panel,
  type PanelLive,
  panels,
  pause,
  phase,
  readied,
  runToEnd,
  scenario,
  stepIteration,
} from '../state'
import { latest } from '../state/live_reports'

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
}

export interface Scripting {
  readonly version: string
  /** Resolves to whether it was opened; if not, the page says why. */
  load(source: string | Session): Promise<boolean>
  /** Runs every panel to its end, or for a number of iterations, and gives the results. */
  run(options?: { iterations?: number }): Promise<PanelResult[]>
  pause(): void
  /** Looks back at an iteration in every panel; null returns to the present. Meanwhile `results` tells of that iteration. */
  look(iteration: number | null): Promise<PanelResult[]>
  results(): PanelResult[]
  session(): Session | null
  /** Runs every planner on the map with many seeds, or any comparison that a document holds. */
  compare(options?: CompareOptions): Promise<ComparisonResult>
  /** A result file of the comparison that is open, as text. */
  resultFile(kind: ResultFile): Promise<string>
}

declare global {
  interface Window {
    formicarium: Scripting
  }
}

const POLL_MS = 30

export function offerScripting(): void {
  window.formicarium = {
    get version() {
      return engineVersion.peek()
    },
    async load(source) {
      if (typeof source === 'string') {
        const taken = await importText(source, { unasked: true })
        pause()
        return taken
      }
      // Scripts older than terrains have no heights.
      const heights = source.scenario.heights ?? null
      loadSession(await readied({ ...source, scenario: { ...source.scenario, heights } }))
      return true
    },
    async run(options = {}) {
      if (options.iterations === undefined) await finishAll()
      else for (let i = 0; i < options.iterations; i++) await oneIteration()
      return results()
    },
    pause,
    async look(iteration) {
      const { lookTo, settle } = await import('../playback/look_back')
      lookTo(iteration ?? Number.POSITIVE_INFINITY)
      await settle()
      return results()
    },
    results,
    session: currentSession,
    async compare(options) {
      const lab = await import('../lab')
      await lab.fetchLab()
      return lab.compare(options)
    },
    resultFile: async (kind) => (await import('../lab')).resultFile(kind),
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
    }
  })
}

async function finishAll(): Promise<void> {
  await until(() => panels.peek().every(settled))
  runToEnd()
  await until(() => phase.peek() === 'finished' || panels.peek().every(ended))
}

async function oneIteration(): Promise<void> {
  await until(() => panels.peek().every(settled))
  const before = panels.peek().map(iterationOf)
  stepIteration()
  await until(() =>
    panels.peek().every((panel, i) => ended(panel) || iterationOf(panel) > (before[i] ?? 0)),
  )
}

const iterationOf = (panel: Panel) => latest(panel.id).summary?.iteration ?? 0

/** Whether its run is loaded, or refused for a reason that will not go away by waiting. */
function settled(panel: Panel): boolean {
  const { summary, error, crashed } = latest(panel.id)
  return summary !== null || error !== null || crashed !== null
}

function ended(panel: Panel): boolean {
  const { summary, error, crashed } = latest(panel.id)
  return error !== null || crashed !== null || (summary !== null && summary.status !== 'running')
}

function rows(panel: Panel): number[][] {
  const flat = historyOf(panel.id).toArray()
  return Array.from({ length: flat.length / 6 }, (_, i) => [...flat.subarray(i * 6, i * 6 + 6)])
}

function pairs(flat: Uint32Array | null): [number, number][] | null {
  if (!flat || flat.length === 0) return null
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i] ?? 0, flat[2 * i + 1] ?? 0])
}

async function until(met: () => boolean): Promise<void> {
  while (!met()) await new Promise((resolve) => setTimeout(resolve, POLL_MS))
}
