import { expect, test } from '@playwright/test'
import { documentOf, readDocument } from '../../../www/src/share/session_document'
import { sessionOf } from './sessions'

const TRACK = { cells: [[1, 1]], size: 2, from_step: 3, steps_per_cell: 4, at_end: 'loop' }
const CHANGE = { at_step: 5, blocked: [[2, 2]], freed: [] }
const DRIVE = { changes: [CHANGE], tracks: [TRACK], sight: 2.5 }

const plain = JSON.parse(JSON.stringify(documentOf(sessionOf(4, 3, new Uint8Array(12)), '0')))
const driving = (drive: unknown) =>
  readDocument({ ...plain, scenario: { ...plain.scenario, drive } })

test('a session carries what moves while a robot drives', () => {
  expect('drive' in plain.scenario).toBe(false)
  expect('drive' in readDocument(plain).spec).toBe(false)
  expect(driving(DRIVE).spec.drive).toEqual(DRIVE)
  const { spec, origin: _, ...session } = driving(DRIVE)
  const whole = sessionOf(4, 3, new Uint8Array(12))
  const again = documentOf({ ...session, scenario: { ...whole.scenario, spec } }, '0')
  expect(again.scenario).toMatchObject({ drive: DRIVE })
  expect(again.format).toBe('formicarium/experiment@1')
})

test('what is left out takes its default', () => {
  expect(driving({}).spec.drive).toEqual({ changes: [], tracks: [] })
  expect(driving({ tracks: [{ cells: [[0, 0]] }] }).spec.drive?.tracks).toEqual([
    { cells: [[0, 0]], size: 1, from_step: 0, steps_per_cell: 1, at_end: 'stay' },
  ])
})

test('what is none of it is refused by name', () => {
  for (const [drive, field] of [
    [7, 'scenario.drive'],
    [{ speed: 1 }, 'scenario.drive.speed'],
    [{ sight: -1 }, 'scenario.drive.sight'],
    [{ changes: [{ ...CHANGE, at: 1 }] }, 'scenario.drive.changes[0].at'],
    [{ changes: [{ ...CHANGE, at_step: 1.5 }] }, 'scenario.drive.changes[0].at_step'],
    [{ changes: [{ ...CHANGE, freed: [[4, 0]] }] }, 'scenario.drive.changes[0].freed[0]'],
    [{ tracks: [{ ...TRACK, cells: [[0, 3]] }] }, 'scenario.drive.tracks[0].cells[0]'],
    [{ tracks: [{ ...TRACK, cells: undefined }] }, 'scenario.drive.tracks[0].cells'],
    [{ tracks: [{ ...TRACK, size: 0 }] }, 'scenario.drive.tracks[0].size'],
    [{ tracks: [{ ...TRACK, at_end: 'turn' }] }, 'scenario.drive.tracks[0].at_end'],
  ] as const)
    expect(() => driving(drive), field).toThrow(field)
})
