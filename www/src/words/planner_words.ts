/** The catalog's own words, in the reader's language where it has them. */
import type { CatalogEntry, ParamSpec } from '@pkg/formicarium'
import { computed } from '@preact/signals'
import { engineText, t } from '../i18n'
import type { ParamValues } from '../model/messages'
import { groundsOf } from '../model/terrain'
import { panels, paramValue, plannerEntry, scenario } from '../state'
import { type Named, names } from '../state/lazy_parts'

/** In the order in which people meet them. */
export const FAMILIES = ['ant-colony', 'swarm', 'sampling', 'search', 'exact'] as const

/** Searches count the cells they look at; colonies and swarms their iterations. */
export function isSearch(planner: string): boolean {
  const family = plannerEntry(planner)?.family
  return family === 'search' || family === 'exact'
}

/** Why a planner cannot be used on a map (by default the one on show): it does not know the ground, or not so many goals. */
export function whyNot({ max_goals, grounds }: CatalogEntry, map = scenario.value): string | null {
  if (!map) return null
  const ground = groundsOf(map).find((asked) => !grounds.includes(asked))
  if (ground) return t(`panels.otherGround.${ground}`)
  const goals = map.spec.goals.length
  return goals > max_goals ? t('panels.tooManyGoals', { count: max_goals, goals }) : null
}

export const plannerName = ({ id, name }: CatalogEntry) => engineText(`planners.${id}.name`, name)

export const plannerSummary = ({ id, summary }: CatalogEntry) =>
  engineText(`planners.${id}.summary`, summary)

/** What a parameter is called; its symbol stands for itself. */
export const paramName = ({ key }: Pick<ParamSpec, 'key'>) =>
  engineText(`paramNames.${key}`, key.replaceAll('_', ' '))

export const paramMeaning = ({ key, meaning }: ParamSpec) =>
  capital(engineText(`params.${key}`, meaning))

/** Options that name a planner are called as it is. */
export const optionName = (id: string) =>
  engineText(`options.${id}`, plannerEntry(id)?.name ?? id.replaceAll('-', ' '))

/** A parameter's value in words: an option by its name, a flag as on or off. */
export const valueName = (value: ParamValues[string]) => {
  if (typeof value === 'boolean') return t(value ? 'parameters.on' : 'parameters.off')
  return typeof value === 'string' ? optionName(value) : String(value)
}

export const presetName = ({ name }: CatalogEntry['presets'][number]) =>
  engineText(`presets.${name}`, name)

/** What a panel is called. */
export const panelTitle = (panelId: number) => titles.value.get(panelId) ?? ''

const titles = computed(() => {
  const labels = labelsOf(panels.value.map(({ setup }) => setup))
  return new Map(panels.value.map(({ id }, at) => [id, labels[at] ?? '']))
})

/** What each of these is called beside the others: as the reader says, or else by its planner and what differs. */
export function labelsOf(all: readonly Named[]): string[] {
  return all.map((one) => {
    if (one.label !== null) return one.label
    const mark = names.value?.markOf(one, all)
    return mark ? `${nameOf(one.planner)} · ${mark}` : nameOf(one.planner)
  })
}

/** Its id when the catalog does not know it. */
export function nameOf(planner: string): string {
  const entry = plannerEntry(planner)
  return entry ? plannerName(entry) : planner
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
