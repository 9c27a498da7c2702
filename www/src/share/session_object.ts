/** A session that a script passes as an object: read as a session file is, so that every way in has the same checks. */
import { type Caption, type Look, type PanelSetup, type Session, SPEEDS } from '../model/session'
import { fieldsOf, integer, invalid } from './field_checks'
import { sessionFromFile, sessionToFile } from './link'

/** A session without what older scripts do not know of: title, note, labels, what was looked at. */
export type GivenSession = Omit<Session, 'panels' | keyof (Caption & Look)> &
  Partial<Caption & Look> & {
    panels: (Omit<PanelSetup, 'label'> & Partial<Pick<PanelSetup, 'label'>>)[]
  }

/** Throws a LinkError that names the field. */
export async function sessionFromObject(value: unknown): Promise<Session> {
  const session = fieldsOf(value, 'session')
  const scenario = fieldsOf(session.scenario, 'session.scenario')
  const spec = fieldsOf(scenario.spec, 'session.scenario.spec')
  const area =
    integer(spec.width, 'session.scenario.spec.width', 1, 4096) *
    integer(spec.height, 'session.scenario.spec.height', 1, 4096)
  integer(session.speed, 'session.speed', 0, SPEEDS.length - 1)
  const cells = numbersOf(scenario.cells, 'session.scenario.cells', area)
  if (cells.some((cell) => cell !== 0 && cell !== 1))
    throw invalid('session.scenario.cells', 'must be 0, free, or 1, blocked')
  // Scripts older than terrains have no heights.
  const heights = scenario.heights
    ? Float32Array.from(numbersOf(scenario.heights, 'session.scenario.heights', area))
    : null
  const whole = { ...scenario, cells: Uint8Array.from(cells), heights }
  return sessionFromFile(sessionToFile({ ...session, scenario: whole } as Session, ''))
}

function numbersOf(value: unknown, field: string, count: number): number[] {
  const isList = Array.isArray(value) || (ArrayBuffer.isView(value) && 'length' in value)
  const list = isList ? Array.from(value as ArrayLike<unknown>) : null
  if (list?.length !== count) throw invalid(field, `must be a list of ${count} numbers, one a cell`)
  if (!list.every((one) => typeof one === 'number')) throw invalid(field, 'must hold numbers alone')
  return list as number[]
}
