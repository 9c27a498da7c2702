import { expect, test } from '@playwright/test'
import type { Cell } from '../../../www/src/model/cell'
import { askSame } from '../../../www/src/model/goals'
import {
  brushed,
  crossing,
  type Moving,
  movingOf,
  newTrack,
  trackTo,
  wallsThatFit,
  withMoving,
  without,
} from '../../../www/src/model/moving'
import type { Scenario } from '../../../www/src/model/session'
import { turnMap } from '../../../www/src/model/turn'
import { sessionOf } from './sessions'

/** Six columns, four rows, a wall at (2, 1); from the upper left to the lower right. */
function scenario(moving?: Partial<Moving>): Scenario {
  const cells = new Uint8Array(24)
  cells[6 + 2] = 1
  const plain = sessionOf(6, 4, cells).scenario
  return moving ? withMoving(plain, { changes: [], tracks: [], ...moving }) : plain
}

test('what moves is nothing to a planner, and leaves no trace where nothing does', () => {
  const plain = scenario()
  const moves = scenario({ tracks: [newTrack([[1, 1]])] })
  expect(askSame(plain.spec, moves.spec)).toBe(true)
  expect('drive' in withMoving(moves, { changes: [], tracks: [] }).spec).toBe(false)
  expect(withMoving(moves, { changes: [], tracks: [], sight: 2 }).spec.drive?.sight).toBe(2)
})

test('a track goes on from neighbour to neighbour, and stays on the map', () => {
  const map = scenario()
  const begun = trackTo(newTrack([]), [0, 3], map)
  expect(begun.cells).toEqual([[0, 3]])
  expect(trackTo(begun, [3, 2], map).cells).toHaveLength(4)
  expect(trackTo(begun, [0, 3], map)).toBe(begun)
  const beyond = trackTo(begun, [0, 9], map)
  expect(beyond).toBe(begun)
})

test('walls are blocked where it is free until then, and freed where it is not', () => {
  const goal = scenario().spec.goals[0]?.at ?? [0, 0]
  const change = { at_step: 3, blocked: [], freed: [] }
  const cells: Cell[] = [[1, 1], [2, 1], goal, [-1, 0]]
  const blocked = brushed(scenario({ changes: [change] }), 0, cells, 'block')
  expect(blocked.changes[0]?.blocked).toEqual([[1, 1]])
  const freed = brushed(scenario({ changes: [change] }), 0, cells, 'free')
  expect(freed.changes[0]?.freed).toEqual([[2, 1]])
  // What an earlier change has freed can be blocked by a later one.
  const later = scenario({ changes: [{ at_step: 1, freed: [[2, 1]] }, change] })
  expect(brushed(later, 1, [[2, 1]], 'block').changes[1]?.blocked).toEqual([[2, 1]])
  const left = brushed(withMoving(scenario(), blocked), 0, [[1, 1]], 'leave')
  expect(left.changes[0]?.blocked).toEqual([])
})

test('of changes only the cells stay that fit the map', () => {
  const changes = [
    {
      at_step: 1,
      blocked: [
        [1, 1],
        [2, 1],
        [7, 7],
      ] as Cell[],
    },
    { at_step: 2, blocked: [[2, 1]] as Cell[] },
  ]
  expect(wallsThatFit(scenario({ changes }))).toEqual([
    { at_step: 1, blocked: [[1, 1]], freed: [] },
  ])
})

test('what moves is turned with its map', () => {
  const moves = scenario({
    tracks: [
      newTrack([
        [0, 1],
        [1, 1],
      ]),
    ],
    changes: [{ at_step: 4, blocked: [[3, 3]] }],
  })
  const { spec } = turnMap(moves, 'mirror')
  expect(spec.drive?.tracks?.[0]?.cells).toEqual([
    [5, 1],
    [4, 1],
  ])
  expect(spec.drive?.changes).toEqual([{ at_step: 4, blocked: [[2, 3]], freed: [] }])
  const back = turnMap(turnMap(moves, 'left'), 'right')
  expect(back.spec.drive?.tracks).toEqual(moves.spec.drive?.tracks)
})

test('what a refusal names is taken out, and nothing else', () => {
  const moving = movingOf(
    scenario({
      tracks: [newTrack([[0, 1]]), newTrack([[1, 1]])],
      changes: [{ at_step: 4, blocked: [[3, 3]] }],
      sight: 3,
    }),
  )
  expect(without(moving, 'drive.tracks[0].cells[3]')?.tracks).toEqual([moving.tracks[1]])
  expect(without(moving, 'drive.tracks')?.tracks).toEqual([])
  expect(without(moving, 'drive.changes[0].at_step')?.changes).toEqual([])
  expect(without(moving, 'drive.sight')).not.toHaveProperty('sight')
  expect(without(moving, 'start')).toBeNull()
})

test('the example crosses the path, or leaves along it where there is no room beside it', () => {
  const straight = Array.from({ length: 6 }, (_, x): Cell => [x, 2])
  const open = crossing(scenario(), straight)
  expect(open?.at_end).toBe('back-and-forth')
  expect(open?.cells.some(([, y]) => y === 2)).toBe(true)
  expect(new Set(open?.cells.map(([x]) => x)).size).toBe(1)
  const cells = new Uint8Array(18).fill(1)
  cells.fill(0, 6, 12)
  const corridor = sessionOf(6, 3, cells).scenario
  const path = straight.map(([x]): Cell => [x, 1])
  expect(crossing(corridor, path)?.at_end).toBe('leave')
  expect(crossing(corridor, path.slice(0, 3))).toBeNull()
})
