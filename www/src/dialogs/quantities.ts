/** Checks how large cells are and how fast one moves, as the engine does. */
import type { EngineError, ScenarioSpec } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { t as tOfDriving } from '../i18n/driving'
import { errorText } from '../i18n/errors'
import { goalAt } from '../model/session'
import { MOST_ENERGY } from '../share/session_vehicle'
import type { Rules } from '../state/movement_rules'
import { useLatest } from './latest_answer'

/** As large as a link may hold. */
const MOST = 1e6

const LABELS = {
  resolution: 'scale.cell',
  speed: 'scale.speed',
  seconds_per_turn: 'scale.turn',
} as const

export const DRIVING_LABELS = {
  max_curvature: 'driving.curvature',
  per_metre: 'driving.perMetre',
  per_radian: 'driving.perRadian',
  per_metre_up: 'driving.perMetreUp',
} as const

export type DrivingQuantity = keyof typeof DRIVING_LABELS
export type Quantity = keyof typeof LABELS | DrivingQuantity

export const isOfDriving = (field: string | null): field is DrivingQuantity =>
  field !== null && field in DRIVING_LABELS

/** A quantity that cannot be used, and why. */
export interface WrongQuantity {
  field: Quantity | null
  /** In the words of the language as it is when it is shown: they may still be on their way. */
  why(): string
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
  const { energy, smoothing, ...pace } = vehicle
  const large =
    firstAbove(MOST, { resolution, ...pace, ...smoothing }) ??
    firstAbove(MOST_ENERGY, { ...energy })
  if (large) return large
  return tools.check(smallest({ ...spec, resolution, vehicle })).then(() => null, refusal)
}

function firstAbove(limit: number, all: Partial<Record<Quantity, number>>): WrongQuantity | null {
  const large = (Object.keys(all) as Quantity[]).find((field) => (all[field] ?? 0) > limit)
  if (!large) return null
  return { field: large, why: () => t('scale.most', { most: numbers.value.whole.format(limit) }) }
}

/** In Chinese it names the field as the form does. */
function refusal(error: EngineError): WrongQuantity {
  const name = error.field.slice(error.field.lastIndexOf('.') + 1)
  const field = name in LABELS || isOfDriving(name) ? (name as Quantity) : null
  return { field, why: () => errorText(field ? { ...error, field: labelOf(field) } : error) }
}

const labelOf = (field: Quantity): string =>
  isOfDriving(field) ? tOfDriving(DRIVING_LABELS[field]) : t(LABELS[field])

/** The engine checks quantities alike on any map. */
function smallest({ name, movement, resolution, vehicle }: ScenarioSpec) {
  const ends = { start: [0, 0] as [number, number], goals: [goalAt([1, 1], '')] }
  const spec = { name, movement, resolution, vehicle, ...ends, width: 2, height: 2 }
  return { spec, cells: new Uint8Array(4), heights: null, factors: null, origin: null }
}
