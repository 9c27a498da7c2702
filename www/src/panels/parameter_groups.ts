/** Which parameters have an effect, and in which order they are shown. */
import type { CatalogEntry, ParamSpec } from '@pkg/formicarium'
import { engineText } from '../i18n'
import type { PanelSetup } from '../model/session'
import { paramValue, plannerEntry } from '../state'
import { paramMeaning, paramName } from '../words/planner_words'

/** What every reader of ant colonies looks for first. */
const CHIEF = ['alpha', 'beta', 'rho', 'ants']
/** What its own parameters are is told by this planner, which has none of its own. */
const COMMON = 'ant-system'
/** As common among planners that are no colonies. */
const ALSO_COMMON = ['decode_limit']

/** Parameters that have an effect beside the others' values. */
export function paramsInForce({ params }: CatalogEntry, setup: PanelSetup): ParamSpec[] {
  return params.filter(({ applies_when }) => {
    const governing = params.find(({ key }) => key === applies_when?.key)
    return !applies_when || !governing || applies_when.values.includes(paramValue(setup, governing))
  })
}

/** α β ρ m and the planner's own; the rest are those that it shares with most. Each in the catalog's order. */
export function inGroups(params: ParamSpec[]): { first: ParamSpec[]; rest: ParamSpec[] } {
  const common = plannerEntry(COMMON)?.params.map(({ key }) => key) ?? []
  const chief = CHIEF.flatMap((key) => params.filter((spec) => spec.key === key))
  const isRest = ({ key }: ParamSpec) => common.includes(key) || ALSO_COMMON.includes(key)
  const others = params.filter((spec) => !chief.includes(spec))
  return {
    first: [...chief, ...others.filter((spec) => !isRest(spec))],
    rest: others.filter(isRest),
  }
}

/** By symbol, name, key or meaning, in the reader's language or English. */
export function matches(spec: ParamSpec, sought: string): boolean {
  const words = [spec.symbol, paramName(spec), spec.key, paramMeaning(spec), spec.meaning]
  return words.some((word) => word.toLowerCase().includes(sought.trim().toLowerCase()))
}

export const unitWords = (unit: string) => engineText(`units.${unit}`, unit)
