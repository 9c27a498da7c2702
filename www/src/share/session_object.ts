/** A session that a script passes as an object: read as a session file is, so that every way in has the same checks. */
import type { ScenarioSpec } from '@pkg/formicarium'
import { MAX_PANELS, type Session, SPEEDS } from '../model/session'
import { type Fields, fieldsOf, integer, invalid, list } from './field_checks'
import { sessionFromFile, sessionToFile } from './link'
import { readChanges } from './session_changes'

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
  // Older scripts have no heights and no factors.
  const heights = scenario.heights
    ? Float32Array.from(numbersOf(scenario.heights, 'session.scenario.heights', area))
    : null
  const factors = scenario.factors
    ? Float32Array.from(numbersOf(scenario.factors, 'session.scenario.factors', area))
    : null
  const whole = { ...scenario, cells: Uint8Array.from(cells), heights, factors }
  checkShapes(session, spec as unknown as ScenarioSpec)
  const read = await sessionFromFile(sessionToFile({ ...session, scenario: whole } as Session, ''))
  if (read.changes && !sameCells(read.scenario.cells, whole.cells))
    throw invalid('session.changes', 'must lead to the cells of the session')
  return read
}

/** What the file would be written from, as far as its reader would not find it wrong by name. */
function checkShapes(session: Fields, spec: ScenarioSpec): void {
  const panels = list(session.panels, 'session.panels', MAX_PANELS)
  for (const [i, panel] of panels.entries()) fieldsOf(panel, `session.panels[${i}]`)
  for (const part of ['inspected', 'lesson'] as const)
    if (session[part] !== undefined && session[part] !== null)
      fieldsOf(session[part], `session.${part}`)
  if (session.keepTrails !== undefined && typeof session.keepTrails !== 'boolean')
    throw invalid('session.keepTrails', 'must be true or false')
  if (session.changes !== undefined) readChanges(session.changes, spec, panels.length)
}

const sameCells = (a: Uint8Array, b: Uint8Array) =>
  a.length === b.length && a.every((cell, i) => cell === b[i])

function numbersOf(value: unknown, field: string, count: number): number[] {
  const isList = Array.isArray(value) || (ArrayBuffer.isView(value) && 'length' in value)
  const list = isList ? Array.from(value as ArrayLike<unknown>) : null
  if (list?.length !== count) throw invalid(field, `must be a list of ${count} numbers, one a cell`)
  if (!list.every((one) => typeof one === 'number')) throw invalid(field, 'must hold numbers alone')
  return list as number[]
}
