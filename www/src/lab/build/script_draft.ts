/** What a script wants compared, checked and put into the draft: the same document comes from it as from the form. */
import type { Budget } from '@pkg/formicarium'
import { gallery } from '../../gallery/gallery'
import type { DraftEntry, DraftMap, Filling } from '../../model/draft'
import { limits } from '../../model/facts'
import type { ParamValues } from '../../model/messages'
import {
  badOption,
  optionsOf,
  ScriptError,
  shortText,
  trueOrFalse,
  wholeNumber,
} from '../../model/script_error'
import type { Asked } from '../../model/scripting'
import { catalog, fetchWholeEngine, plannerEntry } from '../../state'
import { contentOf } from '../../state/script_files'
import { galleryName } from '../../words/map_names'
import { AXES } from './budget'
import { drafted, fillWith, takeRace } from './draft'

export const ASKED = ['planners', 'maps', 'seeds', 'budget', 'untilBudget', 'title'] as const

const USUAL_SEEDS = 30
const MOST_SEED = 0xffffffff
const NO_SIZE = { kind: 'bad-option', hint: 'Leave it out for what is on show.' }

/** Fills the draft; what is not right is thrown before anything of it has changed. */
export async function draftFromScript(asked: Asked): Promise<void> {
  await fetchWholeEngine()
  const budget = budgetOf(asked.budget)
  const changes: Partial<Filling> = {
    seeds: seedsOf(asked.seeds ?? USUAL_SEEDS),
    budget,
    untilBudget: untilOf(asked.untilBudget, budget),
    title: asked.title === undefined ? null : shortText(asked.title, 'title', 120),
    ...(asked.planners && { entries: listOf(asked.planners, 'planners').map(entryOf) }),
    ...(asked.maps && { maps: await mapsOf(listOf(asked.maps, 'maps')) }),
  }
  takeRace()
  const race = drafted()
  if (race) fillWith({ ...race, ...changes, ablated: null })
}

function listOf(value: unknown, field: string): unknown[] {
  if (Array.isArray(value) && value.length > 0) return value
  const { kind, hint } = NO_SIZE
  throw new ScriptError(kind, field, `${field} must be a list of at least one`, hint)
}

function seedsOf(seeds: unknown): { from: number; count: number } {
  if (typeof seeds === 'number')
    return { from: 1, count: wholeNumber(seeds, 'seeds', 1, limits.max_seeds) }
  const { from, count } = optionsOf(seeds, ['from', 'count'], 'seeds')
  const many = wholeNumber(count, 'seeds.count', 1, limits.max_seeds)
  return { from: wholeNumber(from, 'seeds.from', 0, MOST_SEED - many), count: many }
}

function budgetOf(budget: unknown): Budget | null {
  if (budget === undefined || budget === null) return null
  const { axis, amount } = optionsOf(budget, ['axis', 'amount'], 'budget')
  const known = AXES.find((each) => each === axis)
  if (!known) throw badOption('budget.axis', `must be one of ${AXES.join(', ')}`)
  const most = Number.MAX_SAFE_INTEGER
  return { axis: known, amount: wholeNumber(amount, 'budget.amount', 1, most) }
}

function untilOf(until: unknown, budget: Budget | null): boolean {
  if (until === undefined) return false
  const wanted = trueOrFalse(until, 'untilBudget')
  if (!wanted || budget) return wanted
  throw badOption('untilBudget', 'needs a budget')
}

function entryOf(given: unknown, at: number): Omit<DraftEntry, 'key'> {
  const field = `planners[${at}]`
  const known = ['planner', 'preset', 'params', 'label'] as const
  const told = typeof given === 'string' ? { planner: given } : optionsOf(given, known, field)
  const { planner, preset = null, params = {}, label } = told as Partial<Record<string, unknown>>
  const entry = typeof planner === 'string' ? plannerEntry(planner) : undefined
  const ids = catalog.peek()?.planners.map(({ id }) => id) ?? []
  if (!entry) throw unknownName('planner', field, planner, ids)
  const presets = entry.presets.map(({ name }) => name)
  const set = entry.presets.find(({ name }) => name === preset)
  if (preset !== null && !set) throw unknownName('preset', `${field}.preset`, preset, presets)
  const keys = entry.params.map(({ key }) => key)
  if (typeof params !== 'object' || params === null)
    throw badOption(`${field}.params`, 'must be an object of values')
  for (const key of Object.keys(params))
    if (!keys.includes(key)) throw unknownName('parameter', `${field}.params.${key}`, key, keys)
  return {
    planner: entry.id,
    preset: set?.name ?? null,
    params: { ...set?.values, ...(params as ParamValues) },
    label: label === undefined ? null : shortText(label, `${field}.label`, 120),
    id: null,
    ablation: null,
  }
}

function unknownName(what: string, field: string, given: unknown, known: string[]): ScriptError {
  const message = `there is no ${what} "${String(given)}"`
  const hint = known.length > 0 ? `There are ${known.join(', ')}.` : 'It has none.'
  return new ScriptError(`unknown-${what}`, field, message, hint)
}

async function mapsOf(given: unknown[]): Promise<Omit<DraftMap, 'key'>[]> {
  const maps: Omit<DraftMap, 'key'>[] = []
  for (const [at, one] of given.entries()) maps.push(await mapOf(one, `maps[${at}]`))
  return maps
}

async function mapOf(given: unknown, field: string): Promise<Omit<DraftMap, 'key'>> {
  const entry = gallery.find(({ id }) => id === given)
  if (entry) return { name: galleryName(entry.id), scenario: await entry.scenario() }
  const ids = gallery.map(({ id }) => id)
  // No file is one word in small letters: it was meant as an id.
  if (typeof given === 'string' && /^[a-z0-9-]+$/.test(given))
    throw unknownName('map', field, given, ids)
  const { source, ...options } = withOptions(given)
  const content = await contentOf(source, options)
  if (content.kind === 'map')
    return { name: content.scenario.spec.name, scenario: content.scenario }
  if (content.kind === 'session') {
    const { scenario } = content.session
    return { name: scenario.spec.name, scenario }
  }
  const hint = `Give a map, a session, or one of ${ids.join(', ')}.`
  throw new ScriptError('no-map', field, `${content.name} holds no map`, hint)
}

function withOptions(given: unknown): { source: unknown } {
  const isWrapped = typeof given === 'object' && given !== null && 'source' in given
  return isWrapped ? (given as { source: unknown }) : { source: given }
}
