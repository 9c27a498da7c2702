import { expect, test } from '@playwright/test'
import { Estimate } from '../../../www/src/lab/run/estimate'
import { Tasks } from '../../../www/src/lab/run/tasks'
import { fileStem, uniqueId } from '../../../www/src/lab/store/names'
import type { Question } from '../../../www/src/model/comparison'

/** Two maps, three entries of which two can be run, three seeds: twelve runs in four pairs. */
const question: Question = {
  format: 'formicarium/question@1',
  title: 't',
  asks: '?',
  seeds: { from: 7, count: 3 },
  instances: [
    { id: 'a', map: 'a.json' },
    { id: 'b', map: 'b.json' },
  ],
  entries: [
    { id: 'ants', label: 'ants', role: 'other', planner: 'ant-system' },
    { id: 'lost', label: 'lost', role: 'other', missing: 'nowhere' },
    { id: 'exact', label: 'exact', role: 'other', planner: 'astar' },
  ],
}

test('runs are handed out seed by seed, every pair of map and entry once a seed', () => {
  const tasks = new Tasks(question)
  expect([tasks.count, tasks.pairs]).toEqual([12, 4])
  expect(tasks.inOrder()).toEqual([0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 11])
  expect(tasks.inOrder(1)).toEqual([0, 3, 6, 9])
  expect([tasks.pairOf(7), tasks.seedOf(7)]).toEqual([2, 1])
})

test('the time left follows from what each pair has taken, and how much was done at once', () => {
  const estimate = new Estimate(new Tasks(question), 0)
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
