/** The path by hand as a contestant: measured by the engine as planners' paths are, whenever it or the map changes. */
import type { Drawn, Objective, RunSummary } from '@pkg/formicarium'
import { computed, effect, signal } from '@preact/signals'
import { describeError } from '../i18n/errors'
import type { DrawnPath } from '../model/lesson'
import type { Scenario } from '../model/session'
import { blankLive, byHand, lesson, objectives, type Panel, panelById, scenario } from '../state'
import { drawingOn, mapBox, stopDrawing } from './drawing'

/** What the engine says of the path, or why it cannot say anything. */
export interface Measured {
  drawn: DrawnPath
  found: Drawn | null
  refused: string
}

/** No panel has it: the colour is the hand's own. */
export const HAND_SLOT = -1

export const measured = signal<Measured | null>(null)

const past = signal(null)

export function keepMeasuring(): void {
  effect(() => {
    const now = scenario.value
    const drawn = lesson.value?.drawn
    if (!now || !drawn) {
      measured.value = null
      return
    }
    if (measured.peek()?.drawn !== drawn || measuredOn !== now) void measure(now, drawn)
  })
  // Its panel has left the page.
  effect(() => {
    if (drawingOn.value !== null && !panelById(drawingOn.value)) stopDrawing()
  })
  effect(() => {
    byHand.value = contestant.value ? [contestant.value] : []
  })
}

let measuredOn: Scenario | null = null

async function measure(now: Scenario, drawn: DrawnPath): Promise<void> {
  const [found, refused] = await ask(now, drawn)
  if (scenario.peek() !== now || lesson.peek()?.drawn !== drawn) return
  measuredOn = now
  measured.value = { drawn, found, refused }
}

async function ask(now: Scenario, { path }: DrawnPath): Promise<[Drawn | null, string]> {
  try {
    return [await (await mapBox(now)).call('measureDrawn', path), '']
  } catch (error) {
    return [null, describeError(error).message]
  }
}

/** Its value by an objective; null where the path alone does not decide it, or is not complete. */
export function handValue(objective: Objective): number | null {
  const values = measured.value?.found?.values ?? []
  return values.find((each) => each.objective === objective)?.value ?? null
}

const contestant = computed((): Panel | null => {
  const now = measured.value
  const metrics = now?.found?.metrics
  if (!now || !metrics || !now.found?.complete) return null
  const objective = objectives.value.find((each) => handValue(each) !== null) ?? 'length'
  const summary = summaryOf(metrics, objective, handValue(objective))
  const live = signal({ ...blankLive(), summary, objective })
  const setup = { planner: now.drawn.label, preset: null, params: {}, label: null, result: null }
  return { id: HAND_SLOT, slot: HAND_SLOT, setup, live, past }
})

/** Nothing was computed to find it. */
function summaryOf(
  metrics: NonNullable<Drawn['metrics']>,
  objective: Objective,
  value: number | null,
): RunSummary {
  return {
    status: 'complete',
    iteration: 0,
    iteration_budget: null,
    iteration_of_best: null,
    metrics,
    objective,
    value,
    unrefined_length: null,
    tour: null,
    effort: { iterations: 0, constructed_paths: 0, ant_moves: 0, cell_expansions: 0 },
    arrived: 0,
    ants: 0,
    moves: 0,
    digest: '',
  }
}
