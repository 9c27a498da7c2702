/** How the best paths go up and down, as a picture that stands alone. */
import { type Profile, profileOf } from '../charts/profile_data'
import { numbers } from '../i18n'
import { t } from '../i18n/pictures'
import { ground as surface } from '../relief/shown_ground'
import { scenario } from '../state'
import { type Axes, axes, type Box, type Ends, px } from './axes'
import type { Look } from './look'
import { type Ground, headingOf, lookOf, type Picture, runners, WIDTH } from './race_parts'
import { element } from './svg'

const HEIGHT = 320
const BOX: Box = { left: 64, top: 28, right: WIDTH - 16, bottom: HEIGHT - 44 }

/** Null where no path is known yet, or on a plane. */
export function profilePicture(ground: Ground): Picture | null {
  const [now, under] = [scenario.peek(), surface.peek()]
  if (!now || !under) return null
  const bySlices = now.spec.terrain?.slices !== undefined
  const lines = runners().flatMap(({ path, altitudes, colour, label }, i) => {
    if (!path || !altitudes || altitudes.length < 2) return []
    return [
      { colour, label, profile: profileOf(path, altitudes, under, bySlices, bySlices && i === 0) },
    ]
  })
  if (lines.length === 0) return null
  const look = lookOf(ground)
  const { metres } = numbers.peek()
  const write = (value: number) => metres.format(value)
  const made = axes(
    BOX,
    { ends: [0, largest(lines, 'distances')], label: t('profile.distance'), write },
    { ends: heightsOf(lines), label: t('profile.altitude'), write },
    look,
  )
  const plot = element('g', {}, made.drawn)
  for (const { profile } of lines) if (profile.ground) plot.append(below(profile, made, look))
  for (const { profile, colour } of lines)
    plot.append(
      element('polyline', {
        points: pointsOf(profile.distances, profile.altitudes, made),
        fill: 'none',
        stroke: colour,
        'stroke-width': 2,
        'stroke-linejoin': 'round',
      }),
    )
  const what = t('profile.title')
  return {
    drawing: {
      plot,
      height: HEIGHT,
      legend: lines.map(({ label, colour }) => ({ kind: 'line', label, colour, width: 2 })),
      notes: [],
    },
    heading: headingOf(what),
    words: `${what}. ${lines.map(({ label }) => label).join('; ')}`,
    look,
  }
}

type Line = { profile: Profile }

const largest = (lines: Line[], key: 'distances') =>
  Math.max(1, ...lines.map(({ profile }) => profile[key].at(-1) ?? 0))

function heightsOf(lines: Line[]): Ends {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]
  for (const { profile } of lines)
    for (const value of [...profile.altitudes, ...(profile.ground ?? [])])
      if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)]
  const room = Math.max((high - low) * 0.08, 0.5)
  return [low - room, high + room]
}

function pointsOf(distances: number[], heights: number[], { x, y }: Axes): string {
  return distances.map((at, i) => `${px(x(at))},${px(y(heights[i] ?? 0))}`).join(' ')
}

/** The ground, down to the axis. */
function below({ distances, ground }: Profile, made: Axes, look: Look): SVGElement {
  const [from, to] = [made.x(distances[0] ?? 0), made.x(distances.at(-1) ?? 0)].map(px)
  const points = pointsOf(distances, ground ?? [], made)
  return element('polygon', {
    points: `${from},${BOX.bottom} ${points} ${to},${BOX.bottom}`,
    fill: look.muted,
    'fill-opacity': 0.2,
  })
}
