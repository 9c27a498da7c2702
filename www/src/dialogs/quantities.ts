/** Checks how large cells are, how fast one moves and what the robot is like, as the engine does. */
import type { EngineError, ScenarioSpec } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { t as tOfDriving } from '../i18n/driving'
import { errorText } from '../i18n/errors'
import { t as tOfRobot } from '../i18n/weights'
import { goalAt } from '../model/session'
import type { Rules } from '../state/movement_rules'
import { useLatest } from './latest_answer'

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

/** By the engine's names of the fields: two of them end alike. */
export const ROBOT_LABELS = {
  'robot.radius': 'weights.radius',
  'robot.inflation.radius': 'weights.inflationRadius',
  'robot.inflation.cost_scaling': 'weights.scaling',
  'robot.inflation.multiplier': 'weights.multiplier',
} as const

export type DrivingQuantity = keyof typeof DRIVING_LABELS
export type RobotQuantity = keyof typeof ROBOT_LABELS
export type Quantity = keyof typeof LABELS | DrivingQuantity | RobotQuantity

export const isOfDriving = (field: string | null): field is DrivingQuantity =>
  field !== null && field in DRIVING_LABELS

export const isOfRobot = (field: string | null): field is RobotQuantity =>
  field !== null && field in ROBOT_LABELS

/** A quantity that cannot be used, and why. */
export interface WrongQuantity {
  field: Quantity | null
  /** In the words of the language as it is when it is shown: they may still be on their way. */
  why(): string
}

/** What is wrong with the quantities as they stand; null where nothing is, or not yet known. */
export function useWrongQuantity(spec: ScenarioSpec, rules: Rules): WrongQuantity | null {
  const { resolution, vehicle, robot } = rules
  const ask = async () => ({ wrong: await wrongQuantity(spec, rules) })
  return useLatest(JSON.stringify([resolution, vehicle, robot]), ask).answer?.wrong ?? null
}

/** The first quantity that cannot be used; null where all can. */
export async function wrongQuantity(
  spec: ScenarioSpec,
  { resolution, vehicle, robot }: Rules,
): Promise<WrongQuantity | null> {
  return tools.check(smallest({ ...spec, resolution, vehicle, robot })).then(() => null, refusal)
}

/** In Chinese it names the field as the form does. */
function refusal(error: EngineError): WrongQuantity {
  const field = fieldOf(error.field)
  return { field, why: () => errorText(field ? { ...error, field: labelOf(field) } : error) }
}

function fieldOf(field: string): Quantity | null {
  if (isOfRobot(field)) return field
  const name = field.slice(field.lastIndexOf('.') + 1)
  return name in LABELS || isOfDriving(name) ? (name as Quantity) : null
}

function labelOf(field: Quantity): string {
  if (isOfRobot(field)) return tOfRobot(ROBOT_LABELS[field])
  return isOfDriving(field) ? tOfDriving(DRIVING_LABELS[field]) : t(LABELS[field])
}

/** The engine checks quantities alike on any map. */
function smallest({ name, movement, resolution, vehicle, robot }: ScenarioSpec) {
  const ends = { start: [0, 0] as [number, number], goals: [goalAt([1, 1], '')] }
  const spec = {
    ...{ name, movement, resolution, vehicle, ...ends, width: 2, height: 2 },
    ...(robot && { robot }),
  }
  return { spec, cells: new Uint8Array(4), heights: null, factors: null, origin: null }
}
