/**
 * What is proven of weighted sums. Panels may have different weights, so each has a reference of its own: what the catalog's exact planner
 * of this criterion finds by the panel's weights. Fetched with the legends of maps: every race has them, and no first visit waits for them.
 */
import type { CatalogEntry, Reference } from '@pkg/formicarium'
import { computed, effect, signal } from '@preact/signals'
import { ToolBox } from '../engine/tools'
import type { ParamValues } from '../model/messages'
import type { Scenario } from '../model/session'
import type { ToolCalls } from '../model/tool_calls'
import { shownOf } from './looking'
import { held } from './memory'
import { sums } from './optimum'
import { paramValue } from './panels'
import { catalog, type Panel, panels, plannerEntry, scenario } from './store'

/** An option of a parameter, by which planners know the sum. */
const SUM = 'weighted-sum'
/** Long enough that a drag does not ask for every cell it crosses. */
const SETTLE_MS = 150

/** What has been found on the map on show, by values of the exact planner. */
const found = signal<{ on: Scenario | null; by: Map<string, Reference> }>({
  on: null,
  by: new Map(),
})

const exact = computed(() =>
  catalog.value?.planners.find(
    ({ family, params }) =>
      family === 'exact' &&
      params.some(
        ({ kind }) => kind.type === 'choice' && kind.options.some(({ id }) => id === SUM),
      ),
  ),
)

/** Null while it is being computed. */
function referenceOfSum(panel: Panel): Reference | null {
  const { on, by } = found.value
  return (on === scenario.value && by.get(valuesFor(panel))) || null
}

/** The panel's values of the parameters that the exact planner has too, as text. */
function valuesFor({ setup }: Panel): string {
  const theirs = new Set(exact.value?.params.map(({ key }) => key))
  const shared = plannerEntry(setup.planner)?.params.filter(({ key }) => theirs.has(key)) ?? []
  return JSON.stringify(
    Object.fromEntries(shared.map((spec) => [spec.key, paramValue(setup, spec)])),
  )
}

const wanted = computed(() => {
  const summed = panels.value.filter((panel) => shownOf(panel).objective === 'weighted')
  return [...new Set(summed.map(valuesFor))].join('\n')
})

sums.value = referenceOfSum

let timer = 0
effect(() => {
  // A search on a large map takes as much memory as a panel.
  const on = held.value ? null : scenario.value
  const planner = exact.value
  const all = wanted.value
  clearTimeout(timer)
  if (on && planner && all !== '')
    timer = window.setTimeout(() => void proveAll(on, planner, all.split('\n')), SETTLE_MS)
})

/** One after the other, until the map is another one. */
async function proveAll(on: Scenario, planner: CatalogEntry, all: string[]): Promise<void> {
  for (const values of all) {
    const known = found.peek()
    if (known.on === on && known.by.has(values)) continue
    const reference = await prove(on, planner, JSON.parse(values))
    if (scenario.peek() !== on) return
    const by = new Map(found.peek().on === on ? found.peek().by : [])
    found.value = { on, by: by.set(values, reference) }
  }
}

/** A planner that does not take the map proves nothing. */
async function prove(on: Scenario, { id }: CatalogEntry, params: ParamValues): Promise<Reference> {
  const box = new ToolBox<ToolCalls>('whole')
  const { spec, cells, heights, factors } = on
  try {
    const setup = { spec, cells, heights, factors, planner: id, params, seed: 0 }
    const { status, value } = await box.call('repeat', setup, Number.POSITIVE_INFINITY)
    if (status === 'no-path') return { kind: 'no-path' }
    return status === 'optimal' && value !== null ? { kind: 'proven', value } : { kind: 'unknown' }
  } catch {
    return { kind: 'unknown' }
  } finally {
    box.terminate()
  }
}
