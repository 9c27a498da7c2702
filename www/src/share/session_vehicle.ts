/** Who drives, as a session tells it. */
import type { EnergyRule, Vehicle } from '@pkg/formicarium'
import { type Fields, fieldsOf, real } from './field_checks'

const FIELD = 'scenario.vehicle'
const MOST = 1e6
/** In joules a metre up of a hundred tonnes is a million. */
const MOST_ENERGY = 1e9

export function readVehicle({ speed, seconds_per_turn, energy, smoothing }: Fields): Vehicle {
  return {
    speed: real(speed, `${FIELD}.speed`, Number.MIN_VALUE, MOST),
    seconds_per_turn: real(seconds_per_turn, `${FIELD}.seconds_per_turn`, 0, MOST),
    ...(energy != null && { energy: readEnergy(fieldsOf(energy, `${FIELD}.energy`)) }),
    ...(smoothing != null && {
      smoothing: {
        max_curvature: real(
          fieldsOf(smoothing, `${FIELD}.smoothing`).max_curvature,
          `${FIELD}.smoothing.max_curvature`,
          0,
          MOST,
        ),
      },
    }),
  }
}

function readEnergy(fields: Fields): EnergyRule {
  const of = (key: keyof EnergyRule) => real(fields[key], `${FIELD}.energy.${key}`, 0, MOST_ENERGY)
  return {
    per_metre: of('per_metre'),
    per_radian: of('per_radian'),
    per_metre_up: of('per_metre_up'),
  }
}
