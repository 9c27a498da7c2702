/** How one moves on a terrain: its settings as pure functions. Heights count in the file's unit, levels and rules in metres. */
import type { Ground, GroundRule, ScenarioSpec, SliceRules, TerrainFields } from '@pkg/formicarium'
import type { Cell } from './cell'
import { grounds } from './facts'
import type { Scenario } from './session'

/** The ends of a path by slices. */
/** The contour lines of a terrain. */
export interface ContourData {
  /** Metres between a line and the next. */
  interval: number
  /** x0, y0, x1, y1, … in cells. */
  points: Float32Array
  /** For each line the number of points up to its end. */
  ends: Uint32Array
  /** For each line its height in intervals. */
  levels: Int32Array
}

export type End = 'start' | 'goal'

/** How one moves, as far as planners differ in what they know: by the first rule that holds. */
export function groundOf({ terrain, movement }: ScenarioSpec, rules = grounds): Ground {
  const asked = { slices: !!terrain?.slices, moves: movement.moves, terrain: !!terrain }
  const holds = (rule: GroundRule) =>
    (['slices', 'moves', 'terrain'] as const).every(
      (key) => (rule[key] ?? asked[key]) === asked[key],
    )
  return rules.find(holds)?.ground ?? 'plane'
}

/** All that a planner must know of how one moves: where cells have factors, these as well. */
export const groundsOf = ({ spec, factors }: Pick<Scenario, 'spec' | 'factors'>): Ground[] =>
  (factors ?? spec.robot?.inflation) ? [groundOf(spec), 'weighted'] : [groundOf(spec)]

/** A terrain as it is when it comes in: heights in metres, on the surface, without a limit of slope. */
export const plainTerrain = (): TerrainFields => ({ vertical_unit: 1, max_slope: 90 })

/** Whether the height of a cell is unknown: nothing can ever be there. */
export function hasNoData({ heights, spec }: Scenario, [x, y]: Cell): boolean {
  return heights !== null && !Number.isFinite(heights[y * spec.width + x])
}

/** The height of the ground in metres; null on a plane, and where it is unknown. */
export function groundAt({ heights, spec }: Scenario, [x, y]: Cell): number | null {
  const height = heights?.[y * spec.width + x]
  if (height === undefined || !Number.isFinite(height)) return null
  return height * (spec.terrain?.vertical_unit ?? 1)
}

/** The lowest level at which an end of the path may lie: on the ground or above it. */
export function lowestLevel(scenario: Scenario, at: Cell, { level }: SliceRules): number {
  return Math.max(1, Math.ceil((groundAt(scenario, at) ?? 0) / level))
}

/**
 * The same with both ends of the path out of the ground, after one of them or the rules changed; null when even the highest level is
 * below the ground.
 */
export function liftEnds(scenario: Scenario): Scenario | null {
  const { start, goals, terrain } = scenario.spec
  if (!terrain?.slices) return scenario
  const { slices } = terrain
  const start_level = Math.max(slices.start_level, lowestLevel(scenario, start, slices))
  const goal_level = Math.max(
    slices.goal_level,
    lowestLevel(scenario, goals[0]?.at ?? start, slices),
  )
  if (Math.max(start_level, goal_level) > slices.levels) return null
  if (start_level === slices.start_level && goal_level === slices.goal_level) return scenario
  return withSlices(scenario, { ...slices, start_level, goal_level })
}

/** An end raised by a number of levels, as far as ground and highest level allow; the same object where nothing changes. */
export function shiftLevel(scenario: Scenario, end: End, delta: number): Scenario {
  const { spec } = scenario
  const slices = spec.terrain?.slices
  const at = end === 'start' ? spec.start : spec.goals[0]?.at
  if (!slices || !at) return scenario
  const key = end === 'start' ? 'start_level' : 'goal_level'
  const wanted = Math.min(slices.levels, slices[key] + delta)
  const level = Math.max(lowestLevel(scenario, at, slices), wanted)
  if (level === slices[key] || level > slices.levels) return scenario
  return withSlices(scenario, { ...slices, [key]: level })
}

function withSlices(scenario: Scenario, slices: SliceRules): Scenario {
  const { spec } = scenario
  const vertical_unit = spec.terrain?.vertical_unit ?? 1
  return { ...scenario, spec: { ...spec, terrain: { vertical_unit, slices } } }
}
