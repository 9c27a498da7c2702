/** Finds the start or goal marker under a point: they can be dragged with any tool, even when a cell is smaller than its marker. */
import { type Cell, goalOf } from '../maps/edit'
import type { Scenario } from '../session'
import { markRadius } from './draw_map'
import type { Placement, Point } from './view'

export interface Grabbed {
  kind: 'start' | 'goal'
  at: Cell
}

/** Fingers are wider than pointers. CSS pixels. */
const FINGER = 14

export function grabbed(
  scenario: Scenario,
  at: Point,
  place: Placement,
  dpr: number,
  touch: boolean,
): Grabbed | null {
  const reach = Math.max(markRadius({ scale: place.scale, dpr }), touch ? FINGER * dpr : 0)
  const ends: Grabbed[] = [
    { kind: 'start', at: scenario.spec.start },
    { kind: 'goal', at: goalOf(scenario) },
  ]
  const within = ends.filter((end) => distance(end.at, at, place) <= reach)
  within.sort((a, b) => distance(a.at, at, place) - distance(b.at, at, place))
  return within[0] ?? null
}

function distance([x, y]: Cell, at: Point, { scale, originX, originY }: Placement): number {
  return Math.hypot(originX + (x + 0.5) * scale - at[0], originY + (y + 0.5) * scale - at[1])
}
