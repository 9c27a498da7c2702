/**
 * `window.formicarium`: what lessons, tests and the console may ask of the page. docs/scripting.md describes it.
 *
 *     await formicarium.load(link)             // a share link, the text of any file we read, a session, a File, Files
 *     await formicarium.run()                  // to the end of every panel, or a stop; or { iterations: 20, stops: 'ignore' }
 *     formicarium.results()                    // one entry a panel
 *     await formicarium.look(12)               // all panels as they stood after iteration 12; null for now
 *     await formicarium.compare({ seeds: 30 }) // map and planners over many seeds; the result files as text
 */
import type { PanelResult, Scripting } from '../model/scripting'
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
