/** Checks how large cells are and how fast one moves, as the engine does. */
import type { EngineError, ScenarioSpec } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { errorText } from '../i18n/errors'
import { goalAt } from '../model/session'
import type { Rules } from '../state/movement_rules'
import { useLatest } from './latest_answer'

/** As large as a link may hold. */
const MOST = 1e6

export type Quantity = 'resolution' | 'speed' | 'seconds_per_turn'

/** A quantity that cannot be used, and why. */
export interface WrongQuantity {
  field: Quantity | null
  why: string
}

/** What is wrong with the quantities as they stand; null where nothing is, or not yet known. */
export function useWrongQuantity(spec: ScenarioSpec, rules: Rules): WrongQuantity | null {
  const { resolution, vehicle } = rules
  const ask = async () => ({ wrong: await wrongQuantity(spec, rules) })
  return useLatest(JSON.stringify([resolution, vehicle]), ask).answer?.wrong ?? null
}

/** The first quantity that cannot be used; null where all can. */
export async function wrongQuantity(
  spec: ScenarioSpec,
  { resolution, vehicle }: Rules,
): Promise<WrongQuantity | null> {
  const all = { resolution, ...vehicle }
  const large = (Object.keys(all) as Quantity[]).find((field) => all[field] > MOST)
  if (large) {
    const most = numbers.peek().whole.format(MOST)
    return { field: large, why: t('scale.most', { most }) }
  }
  return tools.check(smallest({ ...spec, resolution, vehicle })).then(() => null, refusal)
}

const LABELS = {
  resolution: 'scale.cell',
  speed: 'scale.speed',
  seconds_per_turn: 'scale.turn',
} as const

/** In Chinese it names the field as the form does. */
function refusal(error: EngineError): WrongQuantity {
  const field = error.field in LABELS ? (error.field as Quantity) : null
  return { field, why: errorText(field ? { ...error, field: t(LABELS[field]) } : error) }
}

/** The engine checks quantities alike on any map. */
function smallest({ name, movement, resolution, vehicle }: ScenarioSpec) {
  const ends = { start: [0, 0] as [number, number], goals: [goalAt([1, 1], '')] }
  const spec = { name, movement, resolution, vehicle, ...ends, width: 2, height: 2 }
  return { spec, cells: new Uint8Array(4), heights: null, factors: null, origin: null }
}
