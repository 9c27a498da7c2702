/** Levels of start and goal, where one moves by slices. */
import { t } from '../i18n'
import { type End, shiftLevel } from '../model/terrain'
import { announce } from './notices'
import { commit } from './scenarios'
import { scenario } from './store'

/** Levels that are changed one after the other are undone together. */
const GESTURES: Record<End, number> = { start: -1, goal: -2 }

/** Raises or lowers an end of the paths by slices, as far as there are levels above the ground. */
export function changeLevel(end: End, delta: number): void {
  const now = scenario.peek()
  const before = now?.spec.terrain?.slices
  if (!now || !before) return
  const after = shiftLevel(now, end, delta)
  commit(after, GESTURES[end])
  const rules = after.spec.terrain?.slices ?? before
  const level = end === 'start' ? rules.start_level : rules.goal_level
  const key = after === now ? 'terrain.levelStays' : 'terrain.levelIs'
  const metres = Math.round(level * rules.level)
  announce(t(key, { end: t(`stage.${end}`), level, levels: rules.levels, metres }))
}
