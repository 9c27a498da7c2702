/**
 * The session document: a session as JSON, without the map's cells. A link carries it in a packed container (codec.ts), a
 * file carries it with the cells as rows of text (link.ts).
 */
import type {
  CornerRule,
  CostRule,
  Inflation,
  Limits,
  Measure,
  Movement,
  Robot,
  ScenarioSpec,
  SliceRules,
  Status,
  TerrainFields,
  World,
} from '@pkg/formicarium'
import { FACTS } from '../model/facts'
import type { ParamValues } from '../model/messages'
import {
  layerChoices,
  MAX_PANELS,
  type Origin,
  type PanelSetup,
  type RecordedResult,
  type Session,
  SPEEDS,
  type Sync,
} from '../model/session'
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
import { readLesson } from './lesson_fields'
import { LinkError } from './link_error'
import { readChanges } from './session_changes'
import { readDrive } from './session_drive'
import { readVehicle } from './session_vehicle'
import {
  MOST_ITERATIONS,
  panelFields,
  readCaption,
  readLabel,
  readLook,
  wordsOf,
} from './session_words'

export const FORMAT = 'formicarium/experiment@1'
/** With changes of walls, which a reader of version 1 would leave out. */
export const CHANGING = 'formicarium/experiment@2'
/** With factors of cells or a robot, with or without changes: to readers of the others every map is plain ground for a point. */
export const WEIGHTED = 'formicarium/experiment@3'
const FORMATS = [FORMAT, CHANGING, WEIGHTED]

const SEED_MAX = 2 ** 32 - 1
/** Every value of a type, by the type check. */
const everyOf = <T extends string>(values: Record<T, true>) => Object.keys(values) as T[]

const SYNCS = everyOf<Sync>({ moves: true, iterations: true, paths: true, time: true })
const STATUSES = everyOf<Status>({
  running: true,
  optimal: true,
  complete: true,
  stagnated: true,
  'budget-spent': true,
  'no-path': true,
})
const MEASURES = everyOf<Measure>({ cost: true, length: true })
const COST_RULES = everyOf<CostRule>({ 'nav2-smac-2d': true, 'nav2-navfn': true })
const CORNER_RULES = everyOf<CornerRule>({ always: true, 'one-free': true, 'both-free': true })

/** A session whose cells travel beside it. */
export type Described = Omit<Session, 'scenario'> & { spec: ScenarioSpec; origin: Origin | null }

/** The scenario of `session` is on the map that travels with the document: the one before all changes. */
export function documentOf(session: Session, engine: string): Fields {
  const { scenario, panels, seed, sync, speed, layer, lesson, changes, keepTrails } = session
  return {
    format: formatOf(session),
    engine,
    scenario: {
      ...scenario.spec,
      ...(scenario.origin && { origin: scenario.origin }),
      ...(changes && { changes }),
    },
    panels: panels.map(panelFields),
    seed,
    sync,
    speed: SPEEDS[speed]?.id ?? 'move',
    layer,
    ...wordsOf(session),
    ...(lesson && { lesson }),
    ...(keepTrails && { keep_trails: true }),
  }
}

function formatOf({ scenario: { factors, spec }, changes }: Session): string {
  if (factors ?? spec.robot) return WEIGHTED
  return changes ? CHANGING : FORMAT
}

/** Reads a document; everything in it is checked, because links are made by anyone. Limits and names are those that are `known`. */
export function readDocument(value: unknown, known = FACTS): Described {
  const fields = fieldsOf(value, 'document')
  checkFormat(fields.format)
  const { origin, changes, ...given } = fieldsOf(fields.scenario, 'scenario')
  const spec = readSpec(given, known.limits)
  const panels = list(fields.panels, 'panels', MAX_PANELS).map((panel, i) =>
    readPanel(panel, `panels[${i}]`),
  )
  if (fields.format !== WEIGHTED && (changes !== undefined) !== (fields.format === CHANGING))
    throw invalid('scenario.changes', `and ${CHANGING} must come together`)
  if (spec.robot && fields.format !== WEIGHTED)
    throw invalid('scenario.robot', `and ${WEIGHTED} must come together`)
  return {
    spec,
    origin:
      origin === undefined || origin === null
        ? null
        : readOrigin(fieldsOf(origin, 'scenario.origin'), known),
    panels,
    ...(changes !== undefined && { changes: readChanges(changes, spec, panels.length) }),
    ...(readKeepTrails(fields.keep_trails) && { keepTrails: true as const }),
    seed: integer(fields.seed, 'seed', 0, SEED_MAX),
    sync: oneOf(fields.sync, 'sync', SYNCS),
    speed: SPEEDS.findIndex(
      ({ id }) =>
        id ===
        oneOf(
          fields.speed,
          'speed',
          SPEEDS.map((speed) => speed.id),
        ),
    ),
    layer: oneOf(fields.layer, 'layer', layerChoices(known.layers)),
    ...readCaption(fields),
    ...readLook(fields, { spec, panels }),
    ...(fields.lesson != null && {
      lesson: readLesson(fieldsOf(fields.lesson, 'lesson'), known.limits),
    }),
  }
}

function readKeepTrails(value: unknown): boolean {
  if (value === undefined || typeof value === 'boolean') return value ?? false
  throw invalid('keep_trails', 'must be true or false')
}

function checkFormat(format: unknown): void {
  if (FORMATS.some((known) => known === format)) return
  const name = typeof format === 'string' ? format.slice(0, 60) : 'no format'
  if (name.startsWith('formicarium/experiment@')) {
    throw new LinkError(
      'link-newer',
      `This session says ${name}; this page reads ${FORMATS.join(', ')}.`,
      'format',
    )
  }
  throw new LinkError('link-foreign', `This is not a Formicarium session (${name}).`, 'format')
}

function readSpec(fields: Fields, limits: Limits): ScenarioSpec {
  const width = side(fields.width, 'scenario.width', limits)
  const height = side(fields.height, 'scenario.height', limits)
  const goals = list(fields.goals, 'scenario.goals', limits.max_goals).map((goal, i) => {
    const field = `scenario.goals[${i}]`
    const { at, name, area, strength, danger } = fieldsOf(goal, field)
    // Documents of before there were several goals have no weights.
    const weight = (value: unknown, key: string) =>
      value === undefined ? 1 : real(value, `${field}.${key}`, Number.MIN_VALUE, 1e6)
    return {
      at: cell(at, `${field}.at`, width, height),
      name: text(name, `${field}.name`, 1000),
      area: weight(area, 'area'),
      strength: weight(strength, 'strength'),
      danger: weight(danger, 'danger'),
    }
  })
  if (goals.length === 0) throw invalid('scenario.goals', 'must name a goal')
  return {
    name: text(fields.name, 'scenario.name', 1000),
    width,
    height,
    resolution: real(fields.resolution, 'scenario.resolution', Number.MIN_VALUE, 1e6),
    movement: readMovement(fieldsOf(fields.movement, 'scenario.movement')),
    start: cell(fields.start, 'scenario.start', width, height),
    goals,
    vehicle: readVehicle(fieldsOf(fields.vehicle, 'scenario.vehicle')),
    ...(fields.terrain != null && {
      terrain: readTerrain(fieldsOf(fields.terrain, 'scenario.terrain'), limits),
    }),
    ...(fields.robot != null && { robot: readRobot(fieldsOf(fields.robot, 'scenario.robot')) }),
    ...(fields.world != null && { world: readWorld(fieldsOf(fields.world, 'scenario.world')) }),
    ...(fields.drive != null && { drive: readDrive(fields.drive, { width, height }) }),
  }
}

/** Whether the engine takes these numbers is the engine's to say. */
function readRobot({ radius, inflation }: Fields): Robot {
  const metres = (value: unknown, key: string) => real(value, `scenario.robot.${key}`, 0, 1e6)
  return {
    radius: metres(radius, 'radius'),
    ...(inflation != null && {
      inflation: readInflation(fieldsOf(inflation, 'scenario.robot.inflation'), metres),
    }),
  }
}

function readInflation(
  { radius, cost_scaling, rule, multiplier }: Fields,
  number: (value: unknown, key: string) => number,
): Inflation {
  return {
    radius: number(radius, 'inflation.radius'),
    cost_scaling: number(cost_scaling, 'inflation.cost_scaling'),
    rule: oneOf(rule ?? 'nav2-smac-2d', 'scenario.robot.inflation.rule', COST_RULES),
    multiplier: number(multiplier ?? 2, 'inflation.multiplier'),
  }
}

/** The place of a map in the world, in metres. */
function readWorld({ x, y, yaw = 0, frame = '' }: Fields): World {
  return {
    x: real(x, 'scenario.world.x', -1e9, 1e9),
    y: real(y, 'scenario.world.y', -1e9, 1e9),
    yaw: real(yaw, 'scenario.world.yaw', -1e3, 1e3),
    frame: text(frame, 'scenario.world.frame', 80),
  }
}

function readTerrain({ vertical_unit, max_slope, slices }: Fields, limits: Limits): TerrainFields {
  const field = 'scenario.terrain'
  return {
    vertical_unit: real(vertical_unit, `${field}.vertical_unit`, Number.MIN_VALUE, 1e6),
    ...(max_slope != null && {
      max_slope: real(max_slope, `${field}.max_slope`, Number.MIN_VALUE, 90),
    }),
    ...(slices != null && { slices: readSlices(fieldsOf(slices, `${field}.slices`), limits) }),
  }
}

function readSlices(fields: Fields, { max_levels, max_reach }: Limits): SliceRules {
  const whole = (key: string, least: number, most: number) =>
    integer(fields[key], `scenario.terrain.slices.${key}`, least, most)
  const levels = whole('levels', 1, max_levels)
  return {
    level: real(fields.level, 'scenario.terrain.slices.level', Number.MIN_VALUE, 1e6),
    levels,
    max_aside: whole('max_aside', 0, max_reach),
    max_climb: whole('max_climb', 0, max_reach),
    start_level: whole('start_level', 1, levels),
    goal_level: whole('goal_level', 1, levels),
    measure: oneOf(fields.measure, 'scenario.terrain.slices.measure', MEASURES),
  }
}

/** Refused before anything of that size is allocated. */
function side(value: unknown, field: string, { max_side }: Limits): number {
  if (typeof value === 'number' && value > max_side) {
    throw new LinkError(
      'link-too-large',
      `${field} is ${value}; at most ${max_side} cells are allowed.`,
      field,
    )
  }
  return integer(value, field, 1, max_side)
}

function readMovement(fields: Fields): Movement {
  return {
    moves: oneOf(fields.moves, 'scenario.movement.moves', [4, 8, 16] as const),
    corner_rule: oneOf(fields.corner_rule, 'scenario.movement.corner_rule', CORNER_RULES),
  }
}

function readOrigin(fields: Fields, { generators, limits }: typeof FACTS): Origin {
  const ids = generators.map(({ id }) => id)
  return {
    generator: oneOf(fields.generator, 'scenario.origin.generator', ids),
    seed: integer(fields.seed, 'scenario.origin.seed', 0, SEED_MAX),
    density: real(fields.density, 'scenario.origin.density', 0, limits.max_density),
  }
}

function readPanel(value: unknown, field: string): PanelSetup {
  const { planner, preset, params, label, result } = fieldsOf(value, field)
  return {
    planner: text(planner, `${field}.planner`, 64),
    preset: preset === null || preset === undefined ? null : text(preset, `${field}.preset`, 64),
    params: readParams(fieldsOf(params, `${field}.params`), `${field}.params`),
    label: readLabel(label, `${field}.label`),
    result:
      result === null || result === undefined
        ? null
        : readResult(fieldsOf(result, `${field}.result`), `${field}.result`),
  }
}

/** Whether a planner knows these keys and allows these values is the engine's to say. */
function readParams(fields: Fields, field: string): ParamValues {
  const entries = list(Object.entries(fields), field, 100) as [string, unknown][]
  for (const [key, value] of entries) {
    if (!['number', 'string', 'boolean'].includes(typeof value))
      throw invalid(`${field}.${key.slice(0, 64)}`, 'must be a plain value')
  }
  return Object.fromEntries(entries) as ParamValues
}

function readResult(fields: Fields, field: string): RecordedResult {
  const digest = text(fields.digest, `${field}.digest`, 16)
  if (!/^[0-9a-f]{16}$/.test(digest))
    throw invalid(`${field}.digest`, 'must be 16 hexadecimal digits')
  return {
    iterations: integer(fields.iterations, `${field}.iterations`, 0, MOST_ITERATIONS),
    status: oneOf(fields.status, `${field}.status`, STATUSES),
    length: fields.length === null ? null : real(fields.length, `${field}.length`, 0, 1e9),
    digest,
  }
}
