/** What planners are called beside others: panels, charts, tables, pictures, entries of comparisons. One rule for all (see labelsOf). */
import type { ParamSpec } from '@pkg/formicarium'
import { t } from '../i18n/names'
import type { ParamValues } from '../model/messages'
import { hasValuesOf } from '../model/readings'
import { paramValue, plannerEntry } from '../state'
import type { Named } from '../state/lazy_parts'
import { optionName, presetName, runAlike } from './planner_words'

/** What tells one from its namesakes, or from its planner as it comes; of several that run alike, all but the first say which one they are the same as. */
export function markOf(one: Named, all: readonly Named[]): string {
  const namesakes = all.filter(({ label, planner }) => label === null && planner === one.planner)
  const twin = namesakes.slice(0, namesakes.indexOf(one)).findLast((other) => runAlike(one, other))
  if (twin) return t('names.twin', { place: all.indexOf(twin) + 1 })
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

const presetOf = ({ planner, preset, params }: Named) =>
  plannerEntry(planner)?.presets.find((each) => each.name === preset && hasValuesOf(each, params))

/** A value by its symbol; a choice without one speaks for itself. */
function valueWords({ key, symbol, kind }: ParamSpec, value: ParamValues[string]): string {
  const name = symbol || key.replaceAll('_', ' ')
  if (kind.type === 'flag') return `${name} ${t(value ? 'names.on' : 'names.off')}`
  if (kind.type !== 'choice') return `${name} ${value}`
  return symbol ? `${symbol} ${optionName(String(value))}` : optionName(String(value))
}
