/** Keeps the engine's notices and the references in step with the scenario and the panels' objectives. */
import type { Notice, Objective, Reference } from '@pkg/formicarium'
import { computed, effect, signal } from '@preact/signals'
import { tools } from '../engine/tools'
import { toEngineError } from '../model/errors'
import { question } from '../model/goals'
import type { Scenario } from '../model/session'
import { shownOf } from './looking'
import { held } from './memory'
import { walls } from './runs'
import {
  type Panel,
  panels,
  referenceRefusal,
  references,
  scenario,
  scenarioNotices,
} from './store'

/** Long enough that a drag does not ask for every cell it crosses. */
const SETTLE_MS = 150

type Known = Partial<Record<Objective, Reference>>

/** References found so far, by map, then by question: undo and another planner need not ask again. */
const known = new WeakMap<Uint8Array, Map<string, Known>>()

/** Whose reference depends on weights that a panel's planner alone knows. */
const WEIGHTED: Objective = 'weighted'
/** The reference of such a panel, as soon as there is somebody to ask (weighted_optimum.ts). */
export const sums = signal<((panel: Panel) => Reference | null) | null>(null)

/** The panels' objectives that have one reference in order, as text, so that the signal changes only when they do. */
const wanted = computed(() => {
  const used = panels.value.flatMap(({ live }) => live.value.objective ?? [])
  return [...new Set(used)].filter((objective) => objective !== WEIGHTED).join()
})

/** The objectives on show; without a panel that can run, the plainest there is. */
export const objectives = computed((): Objective[] => {
  if (wanted.value !== '') return wanted.value.split(',') as Objective[]
  const spec = scenario.value?.spec
  if (spec?.terrain?.slices) return ['slice-cost']
  return [(spec?.goals.length ?? 1) > 1 ? 'tour-length' : 'length']
})

/** The reference of a panel's result; null while it is being computed, or the panel's objective is not known yet. */
export function referenceOf(panel: Panel): Reference | null {
  const { objective, summary } = shownOf(panel)
  // What is shown may be of the map before a change.
  if (!objective || (summary?.changes ?? 0) !== (walls.made?.() ?? 0)) return null
  if (objective === WEIGHTED) return sums.value?.(panel) ?? null
  const reference = references.value[objective] ?? null
  return reference?.kind === 'unknown' ? (bestOfPanels(objective) ?? reference) : reference
}

/** Where nothing can be proven, the best that any panel has reached so far stands in. */
function bestOfPanels(objective: Objective): Reference | null {
  const lives = panels.value.map(({ live }) => live.value)
  const reached = lives.flatMap((live) =>
    live.objective === objective ? (live.summary?.value ?? []) : [],
  )
  return reached.length > 0 ? { kind: 'unproven', value: Math.min(...reached) } : null
}

export function watchScenario(): void {
  let remarkTimer = 0
  let referenceTimer = 0
  effect(() => {
    const now = scenario.value
    clearTimeout(remarkTimer)
    if (now) remarkTimer = window.setTimeout(() => void remark(now), SETTLE_MS)
  })
  effect(() => {
    // A search on a large map takes as much memory as a panel.
    const now = held.value ? null : scenario.value
    const asked = objectives.value
    clearTimeout(referenceTimer)
    references.value = now ? knownOf(now) : {}
    referenceRefusal.value = null
    if (now) referenceTimer = window.setTimeout(() => void compare(now, asked), SETTLE_MS)
  })
}

async function remark(asked: Scenario): Promise<void> {
  const notices = await remarks(asked)
  if (scenario.peek() === asked) scenarioNotices.value = notices
}

async function remarks(asked: Scenario): Promise<Notice[]> {
  try {
    return await tools.check(asked)
  } catch (thrown) {
    return [noticeOf(thrown)]
  }
}

function noticeOf(thrown: unknown): Notice {
  const { kind, field, message, args } = toEngineError(thrown)
  return { kind, message, args: { ...args, field } }
}

/** One after the other, quick ones first. */
async function compare(asked: Scenario, by: Objective[]): Promise<void> {
  for (const objective of by) {
    if (knownOf(asked)[objective]) continue
    const found = await lookUp(asked, objective)
    if (found) note(asked, objective, found)
    if (scenario.peek() !== asked) return
    references.value = knownOf(asked)
  }
}

/** A scenario that cannot be used has no reference, and the page says why. */
async function lookUp(asked: Scenario, objective: Objective): Promise<Reference | null> {
  try {
    return await tools.reference(asked, objective)
  } catch (thrown) {
    if (scenario.peek() === asked) referenceRefusal.value = noticeOf(thrown)
    return null
  }
}

function note(on: Scenario, objective: Objective, found: Reference): void {
  const byQuestion = known.get(on.cells) ?? new Map<string, Known>()
  known.set(on.cells, byQuestion)
  byQuestion.set(questionOf(on), { ...knownOf(on), [objective]: found })
}

const knownOf = (on: Scenario): Known => known.get(on.cells)?.get(questionOf(on)) ?? {}

const questionOf = ({ spec }: Scenario): string => JSON.stringify(question(spec))
