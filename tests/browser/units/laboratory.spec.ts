import { expect, test } from '@playwright/test'
import { Estimate } from '../../../www/src/lab/run/estimate'
import { Tasks } from '../../../www/src/lab/run/tasks'
import { fileStem, uniqueId } from '../../../www/src/lab/store/names'

/** Two maps, three entries of which the second cannot be run, three seeds from 7 on: twelve runs of four pairs. */
const tasks = new Tasks({
  tasks: Uint32Array.from(
    [0, 1]
      .flatMap((map) => [0, 2].flatMap((entry) => [7, 8, 9].map((seed) => [map, entry, seed])))
      .flat(),
  ),
  order: Uint32Array.of(0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 11),
})

test('runs are handed out as the engine orders them, or those of the first seeds alone', () => {
  expect(tasks.inOrder()).toEqual([0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 11])
  expect(tasks.inOrder(2)).toEqual([0, 3, 6, 9, 1, 4, 7, 10])
  expect(tasks.inOrder(9)).toHaveLength(12)
})

test('a run is known by its entry and seed, and by the pair of map and entry', () => {
  expect([tasks.entryOf(4), tasks.seedOf(4)]).toEqual([2, 8])
  const pairs = Array.from({ length: 12 }, (_, index) => tasks.pairOf(index))
  expect(new Set(pairs).size).toBe(4)
  expect(new Set(pairs.slice(3, 6)).size).toBe(1)
})

test('the time left follows from what each pair has taken, and how much was done at once', () => {
  const estimate = new Estimate(tasks, 0)
  expect(estimate.secondsLeft([1])).toBeNull()
  // Two workers: pair 0 takes 4 s, pair 1 takes 1 s, and 10 s of work were done in 5 s.
  estimate.done(0, 4, 2.5)
  estimate.done(3, 1, 2.5)
  estimate.done(1, 4, 5)
  estimate.done(4, 1, 5)
  // 4 s, 1 s, and for an unseen pair the mean of 2.5 s; at twice the clock's pace, apart from what has faded.
  const left = estimate.secondsLeft([2, 5, 6]) ?? Number.NaN
  expect(left).toBeGreaterThan(0.95 * (7.5 / 2))
  expect(left).toBeLessThan(1.05 * (7.5 / 2))
})

test('files and ids have plain names', () => {
  expect(fileStem('Ant System – A* on Two corridors')).toBe('ant-system-a-on-two-corridors')
  expect(fileStem('蚁群 比较')).toBe('蚁群-比较')
  expect(fileStem('***')).toBe('comparison')
  expect(uniqueId('Two corridors', [])).toBe('two-corridors')
  expect(uniqueId('Two corridors', ['two-corridors', 'two-corridors-2'])).toBe('two-corridors-3')
  expect(uniqueId('双走廊', [])).toBe('map')
})
