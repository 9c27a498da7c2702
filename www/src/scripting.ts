/**
 * `window.formicarium`: what lessons, tests and the console may ask of the page.
 *
 *     await formicarium.load(link)             // a share link, the text of any file we read, or a Session
 *     await formicarium.run()                  // to the end of every panel; or { iterations: 20 }
 *     formicarium.results()                    // one entry a panel
 */
import type { RunSummary } from '@pkg/formicarium'
import type { Session } from './session'
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
  runToEnd,
  stepIteration,
} from './state'
import { latest } from './state/live'

export interface PanelResult {
  planner: string
  params: Session['panels'][number]['params']
  summary: RunSummary | null
  /** Best path as [x, y] cells; null when none was found. */
  path: [number, number][] | null
  /** On a terrain the altitude of each of its cells in metres; null elsewhere. */
  altitudes: number[] | null
  /** One row an iteration: iteration, best so far, iteration best, mean, worst, arrived. */
  history: number[][]
  verified: PanelLive['verified']
}

export interface Scripting {
  readonly version: string
  /** Resolves to whether it was taken; why not, the page says. */
  load(source: string | Session): Promise<boolean>
  /** Runs every panel to its end, or by so many iterations, and gives the results. */
  run(options?: { iterations?: number }): Promise<PanelResult[]>
  pause(): void
  results(): PanelResult[]
  session(): Session | null
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
      // Scripts of before there were terrains do not speak of heights.
      const heights = source.scenario.heights ?? null
      loadSession({ ...source, scenario: { ...source.scenario, heights } })
      return true
    },
    async run(options = {}) {
      if (options.iterations === undefined) await finishAll()
      else for (let i = 0; i < options.iterations; i++) await oneIteration()
      return results()
    },
    pause,
    results,
    session: currentSession,
  }
}

function results(): PanelResult[] {
  return panels.peek().map((panel) => {
    const live = latest(panel.id)
    const { planner, params } = panel.setup
    const { summary, verified } = live
    return {
      planner,
      params,
      summary,
      path: pairs(live.bestPath),
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

/** Loaded, or refused for a reason that waiting will not mend. */
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
