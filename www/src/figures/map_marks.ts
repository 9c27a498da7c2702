/** What lies on a map in a picture: paths in cells, ends and names in pixels. */
import type { Smoothed } from '@pkg/formicarium'
import { CURVE_COLOURS } from '../drawing/draw_curve'
import { MAP_COLOURS } from '../drawing/draw_map'
import { MARK_COLOURS } from '../drawing/draw_marks'
import { goalName } from '../model/goals'
import type { Scenario } from '../model/session'
import { px } from './axes'
import { FONT } from './look'
import type { Runner } from './race_parts'
import { element } from './svg'

type Theme = keyof typeof MARK_COLOURS

/** Pixels. */
const PATH = 3
const HALO = 6
const CURVE = 1.5
const CURVE_HALO = 3
const MARK = 7

/** In cells, from the middle of each cell to that of the next, its smooth curve over it; `scale` is pixels a cell. */
export function pathOf(
  { path, colour, name }: Pick<Runner, 'path' | 'colour' | 'name'>,
  curve: Smoothed | null,
  scale: number,
  theme: Theme,
): SVGElement[] {
  if (!path) return []
  const cells: [number, number][] = []
  for (let i = 0; i + 1 < path.length; i += 2) cells.push([path[i] ?? 0, path[i + 1] ?? 0])
  const { halo } = MAP_COLOURS[theme]
  const drawn = lineThrough(cells, scale, { class: 'path', stroke: colour, width: PATH })
  drawn.append(element('title', {}, name))
  const lines = [lineThrough(cells, scale, { class: 'halo', stroke: halo, width: HALO }), drawn]
  if (!curve?.is_curve) return lines
  const over = { class: 'curve', stroke: CURVE_COLOURS[theme], width: CURVE }
  return [
    ...lines,
    lineThrough(curve.points, scale, { class: 'halo', stroke: halo, width: CURVE_HALO }),
    lineThrough(curve.points, scale, over),
  ]
}

interface LineLook {
  class: string
  stroke: string
  /** Pixels. */
  width: number
}

function lineThrough(
  points: [number, number][],
  scale: number,
  { width, ...look }: LineLook,
): SVGElement {
  return element('polyline', {
    ...look,
    points: points.map((point) => point.map((at) => Number((at + 0.5).toFixed(4)))).join(' '),
    fill: 'none',
    'stroke-width': Number((width / scale).toFixed(4)),
    'stroke-linejoin': 'round',
    'stroke-linecap': 'round',
  })
}

/** The start is a disc with a hole, a goal a diamond, as on the page. `order`: the goals in the order of their visits. */
export function endsOf(
  { spec }: Scenario,
  scale: number,
  theme: Theme,
  order: number[],
): SVGElement[] {
  const colours = MARK_COLOURS[theme]
  const at = ([x, y]: readonly [number, number]) => [px((x + 0.5) * scale), px((y + 0.5) * scale)]
  const [x, y] = at(spec.start)
  const several = spec.goals.length > 1
  const radius = several ? MARK + 2 : MARK
  const goals = spec.goals.flatMap((goal, index) => {
    const [gx = 0, gy = 0] = at(goal.at)
    const reach = px(1.18 * radius)
    const diamond = element('path', {
      d: `M${gx} ${px(gy - reach)}l${reach} ${reach}l${-reach} ${reach}l${-reach} ${-reach}z`,
      class: 'goal',
      fill: colours.goal,
      stroke: colours.ring,
      'stroke-width': 1.5,
    })
    if (!several) return [diamond]
    const place = order.indexOf(index) + 1
    const number = {
      x: gx,
      y: px(gy + 4),
      'text-anchor': 'middle',
      'font-weight': 700,
      fill: colours.onGoal,
    }
    return [
      nameOf(goalName(spec, index), gx + reach + 4, gy, colours),
      diamond,
      ...(place > 0 ? [element('text', { ...number, 'font-size': 11 }, String(place))] : []),
    ]
  })
  const disc = (r: number, fill: string) => element('circle', { cx: x, cy: y, r, fill })
  return [
    ...goals,
    disc(radius + 1.5, colours.ring),
    disc(radius, colours.start),
    disc(px(0.36 * radius), colours.ring),
  ]
}

function nameOf(name: string, x: number, y: number, colours: (typeof MARK_COLOURS)[Theme]) {
  const halo = { stroke: colours.label, 'stroke-width': 4, 'paint-order': 'stroke' }
  const font = { 'font-family': FONT, 'font-size': 12, 'font-weight': 600 }
  return element('text', { x: px(x), y: px(y + 4), fill: colours.text, ...halo, ...font }, name)
}
