/** What a session carries for a lesson: read strictly, absent when empty; stops at the move where they happen; honest scores. */
import { expect, test } from '@playwright/test'
import { type Answer, scoreOf } from '../../../www/src/lesson/score'
import type { Lesson, Stop } from '../../../www/src/model/lesson'
import type { Session } from '../../../www/src/model/session'
import { packBits, unpack } from '../../../www/src/share/codec'
import { documentOf, readDocument } from '../../../www/src/share/session_document'
import type { Steppable } from '../../../www/src/worker/stepper'
import { StopWatch } from '../../../www/src/worker/stop_watch'
import { generate, sessionOf } from './sessions'

const whole: Lesson = {
  stops: [{ when: 'first-path' }, { when: 'iteration', iterations: 12 }],
  drawn: {
    label: 'by hand',
    path: [
      [0, 0],
      [1, 1],
    ],
  },
  target: { objective: 'length', beat: 40.2 },
  questions: { panel: 0, ant: 4, iteration: 2 },
}

const withLesson = (lesson: Lesson): Session => ({ ...sessionOf(6, 5), lesson })
const document = (lesson: unknown) => ({ ...documentOf(sessionOf(6, 5), '0'), lesson })

test('a lesson comes back from a link and from a document', async () => {
  const session = withLesson(whole)
  expect((await unpack(packBits(session, '0'), generate)).lesson).toEqual(whole)
  const text = JSON.stringify(documentOf(session, '0'))
  expect(readDocument(JSON.parse(text)).lesson).toEqual(whole)
})

test('a session without a lesson says nothing of one: its links keep their bytes', () => {
  const text = JSON.stringify(documentOf(sessionOf(6, 5), '0'))
  expect(text).not.toContain('lesson')
  expect('lesson' in readDocument(JSON.parse(text))).toBe(false)
})

const REFUSED: [string, unknown, string][] = [
  ['an unknown part', { stop: [] }, 'lesson.stop'],
  ['no list of stops', { stops: 'first-path' }, 'lesson.stops'],
  ['no stops at all', { stops: [] }, 'lesson.stops'],
  ['an unknown stop', { stops: [{ when: 'lunch' }] }, 'lesson.stops[0].when'],
  ['a stop twice', { stops: [{ when: 'panel-ends' }, { when: 'panel-ends' }] }, 'lesson.stops'],
  ['a count that is missing', { stops: [{ when: 'iteration' }] }, 'lesson.stops[0].iterations'],
  [
    'a count that is a text',
    { stops: [{ when: 'iteration', iterations: '3' }] },
    'lesson.stops[0].iterations',
  ],
  [
    'a count where none belongs',
    { stops: [{ when: 'first-path', iterations: 3 }] },
    'lesson.stops[0].iterations',
  ],
  ['no path', { drawn: { label: 'x', path: [] } }, 'lesson.drawn.path'],
  ['half a cell', { drawn: { label: 'x', path: [[0, 0.5]] } }, 'lesson.drawn.path[0][1]'],
  ['a long label', { drawn: { label: 'x'.repeat(41), path: [[0, 0]] } }, 'lesson.drawn.label'],
  ['an unknown objective', { target: { objective: 'beauty', beat: 3 } }, 'lesson.target.objective'],
  ['a target of 0', { target: { objective: 'length', beat: 0 } }, 'lesson.target.beat'],
  ['a target in words', { target: { objective: 'length', beat: 'best' } }, 'lesson.target.beat'],
  ['a seventh panel', { questions: { panel: 6, ant: 0, iteration: 0 } }, 'lesson.questions.panel'],
  ['a list', [], 'lesson'],
]

for (const [what, lesson, field] of REFUSED)
  test(`${what} is refused by name`, () => {
    expect(() => readDocument(document(lesson))).toThrow(
      expect.objectContaining({ kind: 'link-invalid', field }),
    )
  })

/** Three moves an iteration; paths are found in iterations 2 and 5. */
class FakeRun implements Steppable {
  moves = 0

  advance(by: 'move' | 'iteration', count: number) {
    for (let i = 0; i < count && this.status() === 'running'; i++)
      this.moves += by === 'move' ? 1 : 3 - (this.moves % 3)
    return this.status()
  }

  iteration() {
    return Math.floor(this.moves / 3)
  }

  status() {
    return this.iteration() >= 9 ? ('budget-spent' as const) : ('running' as const)
  }

  summary() {
    const iteration = this.iteration()
    const iteration_of_best = iteration >= 5 ? 5 : iteration >= 2 ? 2 : null
    const effort = { constructed_paths: 0 }
    return { iteration, status: this.status(), iteration_of_best, effort } as ReturnType<
      Steppable['summary']
    >
  }
}

const STOPS: [Stop, number][] = [
  [{ when: 'first-path' }, 6],
  [{ when: 'better-path' }, 15],
  [{ when: 'iteration', iterations: 4 }, 12],
  [{ when: 'stagnation', iterations: 2 }, 12],
  [{ when: 'panel-ends' }, 27],
]

for (const [stop, moves] of STOPS)
  test(`${stop.when}: the run stands at that very move, however it was driven`, () => {
    const targets = [
      { kind: 'moves', count: 100 },
      { kind: 'iterations', count: 100 },
      { kind: 'until-iteration', iteration: 100 },
      { kind: 'slice' },
    ] as const
    for (const target of targets) {
      const run = new FakeRun()
      const watch = new StopWatch(run, () => 0)
      expect(watch.advance(target, 8, [stop])).toEqual({ reached: true, met: [stop] })
      expect(run.moves, target.kind).toBe(moves)
    }
  })

test('a stop that was met does not hold the run again', () => {
  const run = new FakeRun()
  const watch = new StopWatch(run, () => 0)
  const stops: Stop[] = [{ when: 'first-path' }, { when: 'better-path' }, { when: 'panel-ends' }]
  const met: string[] = []
  for (let round = 0; round < 5; round++)
    met.push(...watch.advance({ kind: 'slice' }, 8, stops).met.map(({ when }) => when))
  expect(met).toEqual(['first-path', 'better-path', 'panel-ends'])
})

test('what was passed without stops is not met afterwards', () => {
  const run = new FakeRun()
  const watch = new StopWatch(run, () => 0)
  watch.advance({ kind: 'moves', count: 1 }, 8, [{ when: 'first-path' }])
  run.advance('iteration', 3)
  const { met } = watch.advance({ kind: 'moves', count: 2 }, 8, [{ when: 'first-path' }])
  expect(met).toEqual([])
})

const move = (x: number, probability: number) => ({
  to: [x, 0] as [number, number],
  level: 0,
  trail: 1,
  heuristic: 1,
  weight: 1,
  probability,
})

test('a score says what was right, and what anybody could expect', () => {
  expect(scoreOf([])).toBeNull()
  const all: Answer[] = [
    { guessed: move(1, 0.5), taken: move(1, 0.5), best: 0.5 },
    { guessed: move(2, 0.1), taken: move(3, 0.6), best: 0.6 },
  ]
  const score = scoreOf(all)
  expect(score?.right).toBe(1)
  expect(score?.count).toBe(2)
  expect(score?.yours).toBeCloseTo(0.3, 12)
  expect(score?.best).toBeCloseTo(0.55, 12)
})
