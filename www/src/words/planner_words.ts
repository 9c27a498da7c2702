/** The catalog's own words, in the reader's language where it has them. */
import type { CatalogEntry, ParamSpec } from '@pkg/formicarium'
import { engineText, t } from '../i18n'
import type { ParamValues } from '../model/messages'
import type { PanelSetup } from '../model/session'
import { groundOf } from '../model/terrain'
import { panelById, panels, plannerEntry, scenario } from '../state'

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

/** Name of a panel's planner, told apart when several panels run the same; its id when the catalog does not know it. */
export function panelTitle(panelId: number): string {
  const planner = panelById(panelId)?.setup.planner ?? ''
  const entry = plannerEntry(planner)
  const name = entry ? plannerName(entry) : planner
  return `${name}${namesakeMark(panelId)}`
}

/**
 * What tells a panel from others with the same planner: its preset, " (paper)", or nothing for the defaults, where it alone
 * has them; else its number, " (2)".
 */
export function namesakeMark(panelId: number): string {
  const planner = panelById(panelId)?.setup.planner
  const namesakes = panels.value.filter(({ setup }) => setup.planner === planner)
  if (namesakes.length < 2) return ''
  const place = namesakes.findIndex(({ id }) => id === panelId)
  const sets = namesakes.map(({ setup }) => setName(setup))
  const set = sets[place] ?? null
  if (set === null || sets.filter((each) => each === set).length > 1) return ` (${place + 1})`
  return set === '' ? '' : ` (${set})`
}

/** A preset's name; empty for the defaults and for values of the reader's own. */
function setName({ planner, preset, params }: PanelSetup): string | null {
  const known = plannerEntry(planner)?.presets.find(({ name }) => name === preset)
  if (known) return presetName(known)
  return Object.keys(params).length === 0 ? '' : null
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1)
}
