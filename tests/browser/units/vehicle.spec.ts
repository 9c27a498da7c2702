/** What a vehicle says of driving, in links and files. */
import type { Vehicle } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import type { Session } from '../../../www/src/model/session'
import { packBits, unpack } from '../../../www/src/share/codec'
import { open, seal } from '../../../www/src/share/envelope'
import { LinkError } from '../../../www/src/share/link_error'
import { documentOf, FORMAT, readDocument } from '../../../www/src/share/session_document'
import { generate, sessionOf } from './sessions'

const ENERGY = { per_metre: 2, per_radian: 0, per_metre_up: 981_000_000 }
const PLAIN: Vehicle = { speed: 0.25, seconds_per_turn: 2.5 }

function driven(vehicle: object): Session {
  const session = sessionOf(8, 4)
  const spec = { ...session.scenario.spec, vehicle: vehicle as Vehicle }
  return { ...session, scenario: { ...session.scenario, spec } }
}

const vehicleOf = ({ scenario }: Session) => scenario.spec.vehicle

/** The field that is refused. */
function refused(vehicle: object): string {
  try {
    readDocument(JSON.parse(JSON.stringify(documentOf(driven(vehicle), '0.1.0'))))
  } catch (error) {
    if (error instanceof LinkError) return error.field
  }
  return ''
}

for (const rules of [
  {},
  { energy: ENERGY },
  { smoothing: { max_curvature: 0 } },
  { energy: ENERGY, smoothing: { max_curvature: 1 / 3 } },
]) {
  test(`a link keeps ${JSON.stringify(rules)}, in the first version`, async () => {
    const session = driven({ ...PLAIN, ...rules })
    expect(documentOf(session, '0.1.0').format).toBe(FORMAT)
    const read = await unpack(await open(await seal(packBits(session, '0.1.0'))), generate)
    expect(vehicleOf(read)).toEqual({ ...PLAIN, ...rules })
  })
}

test('each number is looked at', () => {
  const of = (energy: object) => refused({ ...PLAIN, energy: { ...ENERGY, ...energy } })
  expect(of({})).toBe('')
  expect(of({ per_metre: -1 })).toBe('scenario.vehicle.energy.per_metre')
  expect(of({ per_radian: '1' })).toBe('scenario.vehicle.energy.per_radian')
  expect(of({ per_metre_up: 2e9 })).toBe('scenario.vehicle.energy.per_metre_up')
  expect(of({ per_metre_up: undefined })).toBe('scenario.vehicle.energy.per_metre_up')
  const bent = (max_curvature: unknown) => refused({ ...PLAIN, smoothing: { max_curvature } })
  expect(bent(1e6)).toBe('')
  expect(bent(-1)).toBe('scenario.vehicle.smoothing.max_curvature')
  expect(bent(2e6)).toBe('scenario.vehicle.smoothing.max_curvature')
  expect(refused({ ...PLAIN, energy: 3 })).toBe('scenario.vehicle.energy')
})

test('what a vehicle does not have is not kept', async () => {
  const session = driven({ ...PLAIN, energy: { ...ENERGY, colour: 'red' }, wheels: 4 })
  const read = readDocument(JSON.parse(JSON.stringify(documentOf(session, '0.1.0'))))
  expect(read.spec.vehicle).toEqual({ ...PLAIN, energy: ENERGY })
})
