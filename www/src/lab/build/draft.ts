/** The draft of a comparison: what the builder is putting together. */
import type { Budget } from '@pkg/formicarium'
import { batch, computed, effect, signal, untracked } from '@preact/signals'
import { t } from '../../i18n/lab'
import type { DraftEntry, DraftMap, Filling } from '../../model/draft'
import { askSame } from '../../model/goals'
import type { Scenario } from '../../model/session'
import { caption, notify, panels, plannerEntry, scenario, view } from '../../state'
import { mapName } from '../../words/map_names'

const USUAL_SEEDS = 30
/** Of an entry about which the reader has said nothing. */
const UNTOLD = { label: null, id: null, ablation: null }

export const maps = signal<DraftMap[]>([])
export const entries = signal<DraftEntry[]>([])
export const seeds = signal({ from: 1, count: USUAL_SEEDS })
export const budget = signal<Budget | null>(null)
/** Whether every planner runs until the budget is spent, whatever its own parameters say. */
export const untilBudget = signal(false)
/** As the reader wrote it; null: made from what is compared. */
export const title = signal<string | null>(null)
/** What the reader says of it; empty: that planners are compared. */
export const note = signal('')
/** The name of the planner whose components are taken out one by one; null when this is no ablation. */
export const ablated = signal<string | null>(null)
/** Why the engine refused to start it. */
export const refusal = signal<unknown>(null)

let nextKey = 1
let filled = false

/** Whether it is still empty, and there is a scenario to fill it with. */
export const waitsToBeFilled = () => !filled && scenario.peek() !== null

/** Adds maps that are dropped or pasted while the builder is on show. */
export function takeMapsThatCome(): void {
  effect(() => {
    scenario.value
    if (filled && view.peek() === 'lab') untracked(addCurrentMap)
  })
}

/** Starts from the race: its map and its planners with their parameters. */
export function takeRace(): void {
  batch(() => {
    filled = true
    maps.value = []
    addCurrentMap()
    entries.value = panels.peek().map(({ setup: { planner, preset, params, label } }) => ({
      key: nextKey++,
      planner,
      preset,
      params,
      label,
      id: null,
      ablation: null,
    }))
    ablated.value = null
    title.value = caption.peek().title || null
    note.value = caption.peek().note
    refusal.value = null
  })
}

/** The whole draft; null while it is empty. */
export function drafted(): Required<Filling> | null {
  const now = {
    maps: maps.value,
    entries: entries.value,
    seeds: seeds.value,
    budget: budget.value,
    ablated: ablated.value,
    untilBudget: untilBudget.value,
    title: title.value,
    note: note.value,
  }
  return filled ? now : null
}

/** Replaces the whole draft. */
export function fillWith(all: Filling): void {
  change(() => {
    filled = true
    maps.value = all.maps.map((map) => ({ ...map, key: nextKey++ }))
    entries.value = all.entries.map((entry) => ({ ...entry, key: nextKey++ }))
    seeds.value = all.seeds
    budget.value = all.budget
    untilBudget.value = all.untilBudget ?? false
    ablated.value = all.ablated
    title.value = all.title ?? null
    note.value = all.note ?? ''
  })
}

export function addCurrentMap(): void {
  const now = scenario.peek()
  if (now) addMap(mapName(), now)
}

/** Whether two scenarios ask the same on equal maps, however they have been opened. */
const isSame = (a: Scenario, b: Scenario): boolean =>
  a === b ||
  (askSame(a.spec, b.spec) &&
    sameNumbers(a.cells, b.cells) &&
    sameOrNone(a.heights, b.heights) &&
    sameOrNone(a.factors, b.factors))

const sameNumbers = (a: ArrayLike<number>, b: ArrayLike<number>) =>
  a.length === b.length && Array.prototype.every.call(a, (value, i) => Object.is(value, b[i]))

const sameOrNone = (a: Float32Array | null, b: Float32Array | null) =>
  a === null || b === null ? a === b : sameNumbers(a, b)

/** A map that is there already is not added again. */
export function addMap(name: string, added: Scenario): void {
  if (maps.peek().some((map) => isSame(map.scenario, added))) {
    notify('info', t('lab.build.mapThere', { name }))
    return
  }
  change(() => {
    maps.value = [...maps.peek(), { key: nextKey++, name, scenario: added }]
  })
}

export function removeMap(key: number): void {
  change(() => {
    maps.value = maps.peek().filter((map) => map.key !== key)
  })
}

export function addEntry(planner: string): void {
  const added = { key: nextKey++, planner, preset: null, params: {}, ...UNTOLD }
  change(() => {
    entries.value = [...entries.peek(), added]
  })
}

/** Copies an entry, usually to change one value. */
export function copyEntry(key: number): void {
  change(() => {
    entries.value = entries.peek().flatMap((entry) => {
      if (entry.key !== key) return [entry]
      return [entry, { ...entry, key: nextKey++, ...UNTOLD }]
    })
  })
}

export function removeEntry(key: number): void {
  change(() => {
    entries.value = entries.peek().filter((entry) => entry.key !== key)
  })
}

export function changeEntry(key: number, changes: Partial<Omit<DraftEntry, 'key'>>): void {
  change(() => {
    entries.value = entries
      .peek()
      .map((entry) => (entry.key === key ? { ...entry, ...changes } : entry))
  })
}

/** Replaces all entries. */
export function setEntries(all: Omit<DraftEntry, 'key'>[], ofPlanner: string | null): void {
  change(() => {
    entries.value = all.map((entry) => ({ ...entry, key: nextKey++ }))
    ablated.value = ofPlanner
    title.value = null
  })
}

/** Changes the draft; an earlier refusal no longer holds. */
export function change(how: () => void): void {
  batch(() => {
    refusal.value = null
    how()
  })
}

/** Whether each run of a planner is the same, whatever the seed. */
export const needsNoSeed = (planner: string) => plannerEntry(planner)?.needs_no_seed ?? false

export const runs = computed(
  () => maps.value.length * entries.value.length * Math.max(0, seeds.value.count),
)

/** How many of them are of planners that need no seeds. */
export const runsAlike = computed(
  () =>
    maps.value.length *
    entries.value.filter(({ planner }) => needsNoSeed(planner)).length *
    Math.max(0, seeds.value.count),
)
