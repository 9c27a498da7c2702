import { expect, test } from '@playwright/test'
import type { Cell } from '../../../www/src/model/cell'
import { applyEditTo, type Edit } from '../../../www/src/model/edit'
import { askSame, goalName, goalWeight } from '../../../www/src/model/goals'
import { resized } from '../../../www/src/model/resize'
import type { Scenario } from '../../../www/src/model/session'
import { settleGoals } from '../../../www/src/model/settle_goals'
import { placeOf } from '../../../www/src/model/world'
import { placeError, quantityError, readPlace } from '../../../www/src/panels/goal_input'
import { brushFor, stroke } from '../../../www/src/stage/brush'
import { sessionOf } from './sessions'

/** 10 × 6 cells, nothing blocked, start (0, 0), one goal (9, 5). */
function open(): Scenario {
  const { scenario } = sessionOf(10, 6, new Uint8Array(60))
  const [goal] = scenario.spec.goals
  if (goal) scenario.spec.goals = [{ ...goal, name: 'goal' }]
  return scenario
}

const after = (scenario: Scenario, ...edits: Edit[]) => edits.reduce(applyEditTo, scenario)
const add = (index: number, at: Cell): Edit => ({ kind: 'goal', index, at })
const places = ({ spec }: Scenario) => spec.goals.map(({ at }) => at.join())
const names = ({ spec }: Scenario) => spec.goals.map(({ name }) => name)

test.describe('goals', () => {
  test('the index after the last one adds a goal; letters for those without a name', () => {
    const three = after(open(), add(1, [3, 3]), add(2, [5, 1]))
    expect(places(three)).toEqual(['9,5', '3,3', '5,1'])
    expect(names(three)).toEqual(['A', 'B', 'C'])
    expect(three.spec.goals[2]).toEqual({ at: [5, 1], name: 'C', area: 1, strength: 1, danger: 1 })
    const named = after(sessionOf(10, 6, new Uint8Array(60)).scenario, add(1, [3, 3]))
    expect(names(named)).toEqual(['berth', 'A'])
  })

  test('a removed letter is given again, never one that is in use', () => {
    const scenario = after(
      open(),
      add(1, [3, 3]),
      add(2, [5, 1]),
      { kind: 'remove-goal', index: 1 },
      add(2, [1, 1]),
    )
    expect(names(scenario)).toEqual(['A', 'C', 'B'])
  })

  test('never on the start, on another goal or outside, and never more than 64', () => {
    const two = after(open(), add(1, [3, 3]))
    for (const at of [
      [0, 0],
      [9, 5],
      [10, 0],
      [-1, 0],
    ] as Cell[]) {
      expect(applyEditTo(two, add(2, at))).toBe(two)
      expect(applyEditTo(two, add(1, at))).toBe(two)
    }
    expect(applyEditTo(two, { kind: 'start', at: [3, 3] })).toBe(two)
    let many = sessionOf(80, 4, new Uint8Array(320)).scenario
    for (let i = 1; i < 70; i++) many = applyEditTo(many, add(i, [i, 1]))
    expect(many.spec.goals).toHaveLength(64)
    expect(new Set(names(many)).size).toBe(64)
    expect(brushFor('add-goal', many, [1, 3], 0)).toBeNull()
  })

  test('a goal put on a wall frees its cell, and painting goes round all of them', () => {
    const walled = after(
      open(),
      { kind: 'paint', from: [0, 3], to: [9, 3], blocked: true },
      add(1, [4, 3]),
      { kind: 'paint', from: [4, 0], to: [4, 5], blocked: true },
    )
    expect(walled.cells[3 * 10 + 4]).toBe(0)
    expect(walled.cells.reduce((sum, cell) => sum + cell, 0)).toBe(9 + 5)
  })

  test('the last goal stays', () => {
    const one = open()
    expect(applyEditTo(one, { kind: 'remove-goal', index: 0 })).toBe(one)
    const two = after(one, add(1, [3, 3]))
    expect(places(applyEditTo(two, { kind: 'remove-goal', index: 0 }))).toEqual(['3,3'])
    expect(applyEditTo(two, { kind: 'remove-goal', index: 2 })).toBe(two)
  })

  test('names are for people: another name asks the same question, another weight does not', () => {
    const one = open()
    const renamed = applyEditTo(one, { kind: 'change-goal', index: 0, change: { name: 'Fire' } })
    expect(goalName(renamed.spec, 0)).toBe('Fire')
    expect(askSame(one.spec, renamed.spec)).toBe(true)
    const heavier = applyEditTo(one, { kind: 'change-goal', index: 0, change: { danger: 2 } })
    expect(askSame(one.spec, heavier.spec)).toBe(false)
    expect(applyEditTo(heavier, { kind: 'change-goal', index: 0, change: { danger: 2 } })).toBe(
      heavier,
    )
  })

  test('b = 1 / (s·w·a), with the numbers of the fire paper', () => {
    const weight = (area: number, strength: number, danger: number) =>
      goalWeight({ at: [0, 0], name: '', area, strength, danger })
    expect(weight(1, 1, 1)).toBe(1)
    expect(weight(0.75, 1.2, 2)).toBeCloseTo(0.5556, 4)
    expect(weight(0.5, 1.5, 3.5)).toBeCloseTo(0.381, 3)
    expect(weight(0.25, 1.3, 2.05)).toBeCloseTo(1.5009, 4)
  })

  test('shrinking the map keeps goals inside, apart from each other and from the start', () => {
    const four = after(open(), add(1, [9, 0]), add(2, [2, 1]), add(3, [9, 1]))
    const small = resized(four, 3, 2)
    expect(new Set([...places(small), small.spec.start.join()]).size).toBe(5)
    for (const { at } of small.spec.goals) {
      expect(at[0]).toBeLessThan(3)
      expect(at[1]).toBeLessThan(2)
    }
    // The one that need not move does not.
    expect(places(small)[2]).toBe('2,1')
    const tiny = resized(four, 2, 1)
    expect(tiny.spec.goals).toHaveLength(1)
    expect(tiny.spec.start).not.toEqual(tiny.spec.goals[0]?.at)
  })

  test('on another map the other goals keep names, weights and rough places, where the start can reach', () => {
    const three = after(open(), add(1, [5, 3]), add(2, [9, 0]))
    // 20 × 12 with a wall that shuts the right part off.
    const cells = Uint8Array.from({ length: 240 }, (_, i) => (i % 20 === 12 ? 1 : 0))
    const settled = settleGoals(three.spec.goals, three.spec, {
      width: 20,
      height: 12,
      cells,
      start: [0, 0],
      goal: [10, 6],
    })
    expect(settled.map(({ name }) => name)).toEqual(['A', 'B', 'C'])
    expect(settled[0]?.at).toEqual([10, 6])
    // (5, 3) of 10 × 6 is (10, 6) of 20 × 12, which is taken: one of its neighbours.
    const [, second, third] = settled
    expect(Math.hypot((second?.at[0] ?? 0) - 10, (second?.at[1] ?? 0) - 6)).toBe(1)
    // (9, 0) is (18, 0), behind the wall: the nearest cell before it.
    expect(third?.at).toEqual([11, 0])
  })

  test('the goal tool moves the goal taken up last; a marker under the pointer goes before', () => {
    const two = after(open(), add(1, [3, 3]))
    expect(brushFor('goal', two, [6, 2], 1)).toEqual({ kind: 'goal', index: 1 })
    expect(brushFor('goal', two, [6, 2], 7)).toEqual({ kind: 'goal', index: 1 })
    expect(brushFor('wall', two, [9, 5], 1)).toEqual({ kind: 'goal', index: 0 })
    const brush = brushFor('add-goal', two, [6, 2], 0)
    expect(brush && stroke(brush, [6, 2], [7, 2])).toEqual(add(2, [7, 2]))
  })
})

test.describe('what is typed into the table of goals', () => {
  const { spec } = open()
  const [goal] = spec.goals

  test('quantities are positive numbers, and the refusal names field and value', () => {
    if (!goal) throw new Error('no goal')
    for (const text of ['0', '-1', '', 'much', '1e400', 'NaN']) {
      const error = quantityError(goal, 'strength', text)
      expect([error?.kind, error?.field, error?.args.value]).toEqual(['quantity', 'strength', text])
    }
    for (const text of ['1', '0.25', '1e-3']) expect(quantityError(goal, 'area', text)).toBeNull()
  })

  test('places are column and row', () => {
    const spec = { ...open().spec, resolution: 1 }
    for (const text of ['11, 4', '(11 4)']) expect(readPlace(spec, text)).toEqual([11, 4])
    expect(readPlace(spec, '3;7')).toEqual([3, 7])
    for (const text of ['3', '-3, 1', '2m, 1m', '2 m']) expect(readPlace(spec, text)).toBeNull()
    expect(placeError(spec, 0, '2m, 1m')?.kind).toBe('place')
  })

  test('on a map that has a scale, places are in metres, too', () => {
    const plain = open().spec
    const robots = { ...plain, resolution: 0.5, world: { x: -1, y: 2, yaw: 0, frame: '' } }
    for (const at of [
      [0, 0],
      [3, 2],
    ] as const) {
      const [x = 0, y = 0] = placeOf(robots, [...at]) ?? []
      for (const text of [`${x}m, ${y}m`, `(${x} m ${y} m)`, `${x}米，${y}米`.replace('，', ',')])
        expect(readPlace(robots, text)).toEqual(at)
    }
    const turned = { ...robots, world: { ...robots.world, yaw: 0.7 } }
    const [x = 0, y = 0] = placeOf(turned, [3, 2]) ?? []
    expect(readPlace(turned, `${x}m, ${y}m`)).toEqual([3, 2])
    // From the lower left corner where the map's place is not known.
    const corner = readPlace({ ...plain, resolution: 0.5 }, '0.7m, 0.1m')
    expect(corner).toEqual([1, plain.height - 1])
    expect(readPlace(robots, '−1m, 2m')).toEqual([0, robots.height - 1])
    expect(readPlace(robots, '1m, 2')).toBeNull()
    expect(placeError(robots, 0, '1m, 2')?.kind).toBe('place-in-metres')
    expect(placeError(robots, 0, '-9m, 2m')?.kind).toBe('outside-map')
  })

  test('the start takes any place that no goal has', () => {
    const { spec } = open()
    const [goal] = spec.goals
    expect(placeError(spec, 'start', goal?.at.join(', ') ?? '')?.kind).toBe('start-on-goal')
    expect(placeError(spec, 'start', spec.start.join(', '))).toBeNull()
    expect(placeError(spec, 'start', '9999, 1')).toMatchObject({
      kind: 'outside-map',
      field: 'start',
    })
  })

  test('a place is inside the map and nobody else’s', () => {
    const { spec: two } = after(open(), add(1, [3, 3]))
    expect(placeError(two, 0, 'here')?.kind).toBe('place-in-metres')
    expect(placeError(two, 0, '10, 0')?.kind).toBe('outside-map')
    expect(placeError(two, 0, '3, 3')?.kind).toBe('goal-twice')
    expect(placeError(two, 0, '0, 0')?.kind).toBe('goal-on-start')
    expect(placeError(two, 0, '9, 5')).toBeNull()
  })
})
