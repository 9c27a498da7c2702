/** Finds the start or goal marker under a point: they can be dragged with any tool, even when a cell is smaller than its marker. */

import { markRadius } from '../drawing/mark_radius'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import type { Placement, Point } from '../model/viewpoint'
import type { Brush } from './brush'

export interface MarkerUnder {
  brush: Exclude<Brush, { kind: 'wall' }>
  at: Cell
}

/** Fingers are wider than pointers. CSS pixels. */
const FINGER = 14

export function markerUnder(
  scenario: Scenario,
  at: Point,
  place: Placement,
  dpr: number,
  touch: boolean,
): MarkerUnder | null {
  const several = scenario.spec.goals.length > 1
  const mark = markRadius({ scale: place.scale, dpr }, several)
  const reach = Math.max(mark, touch ? FINGER * dpr : 0)
  const ends: MarkerUnder[] = [
    { brush: { kind: 'start' }, at: scenario.spec.start },
    ...scenario.spec.goals.map(
      ({ at }, index): MarkerUnder => ({ brush: { kind: 'goal', index }, at }),
    ),
  ]
  const within = ends.filter((end) => distance(end.at, at, place) <= reach)
  within.sort((a, b) => distance(a.at, at, place) - distance(b.at, at, place))
  return within[0] ?? null
}

function distance([x, y]: Cell, at: Point, { scale, originX, originY }: Placement): number {
  return Math.hypot(originX + (x + 0.5) * scale - at[0], originY + (y + 0.5) * scale - at[1])
}
