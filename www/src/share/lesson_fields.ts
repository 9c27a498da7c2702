/** What a document says of its lesson: every part is optional, none is accepted as something else. */
import type { Limits, Objective } from '@pkg/formicarium'
import {
  COUNTED,
  type DrawnPath,
  type Lesson,
  LONGEST_LABEL,
  MOST_CELLS_DRAWN,
  MOST_ITERATIONS,
  type Questions,
  STOP_IDS,
  type Stop,
  type StopId,
  type Target,
} from '../model/lesson'
import { MAX_PANELS } from '../model/session'
import {
  cell,
  type Fields,
  fieldsOf,
  integer,
  invalid,
  list,
  oneOf,
  real,
  text,
} from './field_checks'

const EVERY_OBJECTIVE: Record<Objective, true> = {
  length: true,
  'polyline-length': true,
  'slice-cost': true,
  'turn-index': true,
  weighted: true,
  'tour-length': true,
  'tour-weight': true,
}
const OBJECTIVES = Object.keys(EVERY_OBJECTIVE) as Objective[]
const PARTS: readonly (keyof Lesson)[] = ['stops', 'drawn', 'target', 'questions']

export function readLesson(fields: Fields, limits: Limits): Lesson {
  const unknown = Object.keys(fields).find((key) => !PARTS.some((part) => part === key))
  if (unknown !== undefined) throw invalid(`lesson.${unknown.slice(0, 64)}`, 'is not known')
  const { stops, drawn, target, questions } = fields
  return {
    ...(stops !== undefined && { stops: readStops(stops) }),
    ...(drawn !== undefined && { drawn: readDrawn(fieldsOf(drawn, 'lesson.drawn'), limits) }),
    ...(target !== undefined && { target: readTarget(fieldsOf(target, 'lesson.target')) }),
    ...(questions !== undefined && {
      questions: readQuestions(fieldsOf(questions, 'lesson.questions')),
    }),
  }
}

function readStops(value: unknown): Stop[] {
  const stops = list(value, 'lesson.stops', STOP_IDS.length).map((stop, i) =>
    readStop(fieldsOf(stop, `lesson.stops[${i}]`), `lesson.stops[${i}]`),
  )
  if (stops.length === 0) throw invalid('lesson.stops', 'must name a stop')
  const twice = stops.find(({ when }, i) => stops.findIndex((stop) => stop.when === when) < i)
  if (twice) throw invalid('lesson.stops', `names ${twice.when} twice`)
  return stops
}

function readStop(fields: Fields, field: string): Stop {
  const when: StopId = oneOf(fields.when, `${field}.when`, STOP_IDS)
  if (when === 'stagnation' || when === 'iteration')
    return {
      when,
      iterations: integer(fields.iterations, `${field}.iterations`, 1, MOST_ITERATIONS),
    }
  if (fields.iterations !== undefined)
    throw invalid(`${field}.iterations`, `belongs to ${COUNTED.join(' and ')} alone`)
  return { when }
}

/** Whether it is a path on this map, which may have changed since, is the engine's to say. */
function readDrawn({ label, path }: Fields, { max_side }: Limits): DrawnPath {
  const field = 'lesson.drawn.path'
  const cells = list(path, field, MOST_CELLS_DRAWN).map((at, i) =>
    cell(at, `${field}[${i}]`, max_side, max_side),
  )
  if (cells.length === 0) throw invalid(field, 'must have a cell')
  return { label: text(label, 'lesson.drawn.label', LONGEST_LABEL), path: cells }
}

function readTarget({ objective, beat }: Fields): Target {
  return {
    objective: oneOf(objective, 'lesson.target.objective', OBJECTIVES),
    beat: beat === 'optimum' ? beat : real(beat, 'lesson.target.beat', Number.MIN_VALUE, 1e9),
  }
}

function readQuestions({ panel, ant, iteration }: Fields): Questions {
  return {
    panel: integer(panel, 'lesson.questions.panel', 0, MAX_PANELS - 1),
    ant: integer(ant, 'lesson.questions.ant', 0, 2 ** 32 - 1),
    iteration: integer(iteration, 'lesson.questions.iteration', 0, MOST_ITERATIONS),
  }
}
