/** How one moves: the map's size, its moves, and what a terrain asks besides. Fetched with the dialog that asks for them. */
import type {
  Movement,
  Robot,
  ScenarioSpec,
  SliceRules,
  TerrainFields,
  Vehicle,
} from '@pkg/formicarium'
import { t } from '../i18n/dialogs'
import { resized } from '../model/resize'
import type { Scenario } from '../model/session'
import { liftEnds } from '../model/terrain'
import { fitView } from '../model/viewpoint'
import { notify } from './notices'
import { commit } from './scenarios'
import { scenario } from './store'

export interface Rules {
  width: number
  height: number
  movement: Movement
  /** Metres per cell. */
  resolution: number
  /** Metres per second, and seconds for a turn. */
  vehicle: Vehicle
  /** On a terrain alone. */
  terrain?: TerrainFields
  /** None where it is a point. */
  robot?: Robot | undefined
  /** Start and goals in places of their own. */
  ends?: Pick<ScenarioSpec, 'start' | 'goals'> | undefined
}

/** What the rules would make of a scenario; null when there is no place for start or goal: without data, or above all levels. */
export function underRules(now: Scenario, rules: Rules): Scenario | null {
  const { width, height, movement, resolution, vehicle, terrain, robot, ends } = rules
  const resizing = width !== now.spec.width || height !== now.spec.height
  // Levels are looked at once the rules are there that count them.
  const { terrain: former, robot: _, ...plain } = now.spec
  const surface = former ? { terrain: { vertical_unit: former.vertical_unit } } : {}
  const flat = { ...now, spec: { ...plain, ...surface } }
  const sized = resized(flat, width, height)
  if (resizing && sized === flat) return null
  const spec = {
    ...sized.spec,
    movement,
    resolution,
    vehicle,
    ...(now.heights && terrain && { terrain }),
    ...(robot && { robot }),
    ...ends,
  }
  return liftEnds({ ...sized, spec })
}

/** One step to undo, however much changes. False when there is no place for start or goal. */
export function setRules(rules: Rules): boolean {
  const now = scenario.peek()
  const after = now && underRules(now, rules)
  if (!now || !after) return false
  if (JSON.stringify(after.spec) === JSON.stringify(now.spec)) return true
  commit(after)
  tellLifted(rules.terrain?.slices, after.spec.terrain?.slices)
  if (after.cells.length !== now.cells.length || after.spec.width !== now.spec.width) fitView()
  return true
}

/** Levels below the ground are not taken as they were given. */
function tellLifted(asked: SliceRules | undefined, taken: SliceRules | undefined): void {
  if (!asked || !taken) return
  const { start_level: start, goal_level: goal } = taken
  if (start === asked.start_level && goal === asked.goal_level) return
  notify('warning', t('terrain.lifted', { start, goal }), { hint: t('terrain.liftedHint') })
}
