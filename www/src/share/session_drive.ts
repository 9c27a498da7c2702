/** What moves while a robot drives, in a session document: its fields and cells. How many there may be, and where, the engine judges. */
import type { AtEnd, DriveChange, DriveSpec, ScenarioSpec, Track } from '@pkg/formicarium'
import { cell, fieldsOf, integer, invalid, list, oneOf, real } from './field_checks'

/** More than the engine takes of anything. */
const MOST_ENTRIES = 1e6
const MOST_STEPS = 2 ** 32 - 1
/** Every value, by the type check. */
const AT_END = Object.keys({
  stay: true,
  'back-and-forth': true,
  loop: true,
  leave: true,
} satisfies Record<AtEnd, true>) as AtEnd[]

type Sides = Pick<ScenarioSpec, 'width' | 'height'>

/** Everything is checked by name; what is left out takes its default, as in a scenario's file. */
export function readDrive(value: unknown, sides: Sides): DriveSpec {
  const field = 'scenario.drive'
  const { changes = [], tracks = [], sight, ...others } = fieldsOf(value, field)
  refuse(others, field)
  return {
    changes: list(changes, `${field}.changes`, MOST_ENTRIES).map((change, i) =>
      readChange(change, `${field}.changes[${i}]`, sides),
    ),
    tracks: list(tracks, `${field}.tracks`, MOST_ENTRIES).map((track, i) =>
      readTrack(track, `${field}.tracks[${i}]`, sides),
    ),
    ...(sight != null && { sight: real(sight, `${field}.sight`, 0, Number.MAX_VALUE) }),
  }
}

function readChange(value: unknown, field: string, sides: Sides): DriveChange {
  const { at_step, blocked = [], freed = [], ...others } = fieldsOf(value, field)
  refuse(others, field)
  return {
    at_step: integer(at_step, `${field}.at_step`, 0, MOST_STEPS),
    blocked: cells(blocked, `${field}.blocked`, sides),
    freed: cells(freed, `${field}.freed`, sides),
  }
}

function readTrack(value: unknown, field: string, sides: Sides): Track {
  const fields = fieldsOf(value, field)
  const { size = 1, from_step = 0, steps_per_cell = 1, at_end = 'stay', ...rest } = fields
  const { cells: way, ...others } = rest
  refuse(others, field)
  return {
    cells: cells(way, `${field}.cells`, sides),
    size: integer(size, `${field}.size`, 1, MOST_STEPS),
    from_step: integer(from_step, `${field}.from_step`, 0, MOST_STEPS),
    steps_per_cell: integer(steps_per_cell, `${field}.steps_per_cell`, 1, MOST_STEPS),
    at_end: oneOf(at_end, `${field}.at_end`, AT_END),
  }
}

function cells(value: unknown, field: string, { width, height }: Sides): [number, number][] {
  return list(value, field, MOST_ENTRIES).map((each, i) =>
    cell(each, `${field}[${i}]`, width, height),
  )
}

function refuse(others: object, field: string): void {
  for (const other of Object.keys(others)) throw invalid(`${field}.${other}`, 'is no part of it')
}
