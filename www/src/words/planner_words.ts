/** The catalog's own words, in the reader's language where it has them. */
import type { CatalogEntry, ParamSpec } from '@pkg/formicarium'
import { computed } from '@preact/signals'
import { engineText, t } from '../i18n'
import type { ParamValues } from '../model/messages'
import type { PanelSetup } from '../model/session'
import { groundOf } from '../model/terrain'
import { panels, paramValue, plannerEntry, scenario } from '../state'

/** In the order in which people meet them. */
export const FAMILIES = ['ant-colony', 'swarm', 'search', 'exact'] as const

/** Searches count the cells they look at; colonies and swarms their iterations. */
export function isSearch(planner: string): boolean {
  const family = plannerEntry(planner)?.family
  return family === 'search' || family === 'exact'
}

/** Why a planner cannot be used on a map (by default the one on show): it does not know the ground, or not so many goals. */
export function whyNot(
  { max_goals, grounds }: CatalogEntry,
  spec = scenario.value?.spec,
): string | null {
  if (!spec) return null
  const ground = groundOf(spec)
  if (!grounds.includes(ground)) return t(`panels.otherGround.${ground}`)
  const goals = spec.goals.length
  return goals > max_goals ? t('panels.tooManyGoals', { count: max_goals, goals }) : null
}

export const plannerName = ({ id, name }: CatalogEntry) => engineText(`planners.${id}.name`, name)

export const plannerSummary = ({ id, summary }: CatalogEntry) =>
  engineText(`planners.${id}.summary`, summary)

export const paramMeaning = ({ key, meaning }: ParamSpec) =>
  capital(engineText(`params.${key}`, meaning))

/** Options that name a planner are called as it is. */
export const optionName = (id: string) =>
  engineText(`options.${id}`, plannerEntry(id)?.name ?? id.replaceAll('-', ' '))

export const presetName = ({ name }: CatalogEntry['presets'][number]) =>
  engineText(`presets.${name}`, name)

/** A planner with its values, and what the reader calls it. */
export type Named = Pick<PanelSetup, 'planner' | 'preset' | 'params' | 'label'>

/** What a panel is called. */
export const panelTitle = (panelId: number) => titles.value.get(panelId) ?? ''

const titles = computed(() => {
  const labels = labelsOf(panels.value.map(({ setup }) => setup))
  return new Map(panels.value.map(({ id }, at) => [id, labels[at] ?? '']))
})

/** What each of these is called beside the others: as the reader says, or else by its planner and what differs. */
export function labelsOf(all: readonly Named[]): string[] {
  const unnamed = all.filter(({ label }) => label === null)
  return all.map((one) => {
    if (one.label !== null) return one.label
    const mark = markOf(
      one,
      unnamed.filter(({ planner }) => planner === one.planner),
      all,
    )
    return mark ? `${nameOf(one.planner)} · ${mark}` : nameOf(one.planner)
  })
}

/** Its id when the catalog does not know it. */
export function nameOf(planner: string): string {
  const entry = plannerEntry(planner)
  return entry ? plannerName(entry) : planner
}

/** What tells one from its namesakes, or from its planner as it comes; of several that run alike, all but the first say which one they are the same as. */
function markOf(one: Named, namesakes: Named[], all: readonly Named[]): string {
  const twin = namesakes.slice(0, namesakes.indexOf(one)).findLast((other) => runAlike(one, other))
  if (twin) return t('panels.twin', { place: all.indexOf(twin) + 1 })
  const short = valueMark(one, namesakes, MOST_VALUES)
  const unclear = namesakes.some(
    (other) => !runAlike(one, other) && valueMark(other, namesakes, MOST_VALUES) === short,
  )
  return unclear ? valueMark(one, namesakes, Number.POSITIVE_INFINITY) : short
}

/** More values than these are told only where fewer do not tell two apart. */
const MOST_VALUES = 2

/** Its preset, or those of its values that differ among the namesakes without one; alone, those that are not the defaults. */
function valueMark(one: Named, namesakes: Named[], most: number): string {
  const preset = presetOf(one)
  if (preset) return presetName(preset)
  const own = namesakes.filter((other) => !presetOf(other))
  const told = (plannerEntry(one.planner)?.params ?? []).filter((spec) =>
    own.length > 1
      ? own.some((other) => paramValue(other, spec) !== paramValue(one, spec))
      : spec.key in one.params,
  )
  const values = told.slice(0, most).map((spec) => valueWords(spec, paramValue(one, spec)))
  return [...values, ...(told.length > most ? ['…'] : [])].join(', ')
}

/** Whose very values it has: those of an old link may be others by now. */
const presetOf = ({ planner, preset, params }: Named) =>
  plannerEntry(planner)?.presets.find(
    ({ name, values }) =>
      name === preset &&
      Object.keys(values).length === Object.keys(params).length &&
      Object.entries(values).every(([key, value]) => params[key] === value),
  )

/** A value by its symbol; a choice without one speaks for itself. */
function valueWords({ key, symbol, kind }: ParamSpec, value: ParamValues[string]): string {
  const name = symbol || key.replaceAll('_', ' ')
  if (kind.type === 'flag') return `${name} ${t(value ? 'panels.on' : 'panels.off')}`
  if (kind.type !== 'choice') return `${name} ${value}`
  return symbol ? `${symbol} ${optionName(String(value))}` : optionName(String(value))
}

/** All panels share a seed, so equal values make equal runs. */
export function runAlike(a: Named, b: Named): boolean {
  if (a.planner !== b.planner) return false
  const known = plannerEntry(a.planner)
  if (!known) return JSON.stringify(a.params) === JSON.stringify(b.params)
  return known.params.every((spec) => paramValue(a, spec) === paramValue(b, spec))
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1)
}
