/** How the runs converge, as a picture that stands alone. */
import { type Curve, curvesOf } from '../charts/convergence_data'
import { levels, showIterationBest, showMean, showsCost } from '../charts/shown_curves'
import { numbers } from '../i18n'
import { t } from '../i18n/pictures'
import { lookedAt, panels } from '../state'
import { lengthShown } from '../words/lengths'
import { metresPerCell, withUnit } from '../words/metres'
import { objectiveWord } from '../words/objective_words'
import { type Axes, axes, type Box, type Ends, px } from './axes'
import type { LegendItem } from './frame'
import type { Look } from './look'
import { type Ground, headingOf, lookOf, type Picture, runners, WIDTH } from './race_parts'
import { element } from './svg'

const HEIGHT = 380
const BOX: Box = { left: 56, top: 28, right: WIDTH - 12, bottom: HEIGHT - 44 }
/** Room above and below, as a part of what is on show. */
const ROOM = 0.08
const LEVEL_DASH = '2 4'
const MEAN_DASH = '4 3'

interface Line {
  curve: Curve
  colour: string
  kind: 'best' | 'iterationBest' | 'mean'
}

const LINES = {
  mean: { 'stroke-width': 1, 'stroke-opacity': 0.6, 'stroke-dasharray': MEAN_DASH },
  iterationBest: { 'stroke-width': 1, 'stroke-opacity': 0.6 },
  best: { 'stroke-width': 2.5 },
} as const

export function convergencePicture(ground: Ground): Picture {
  const look = lookOf(ground)
  const { iterations, panels: curves } = curvesOf(panels.peek())
  const scale = metresPerCell.peek() ?? 1
  const all = runners()
  const lines = curves.flatMap(({ best, iterationBest, mean }, i): Line[] => {
    const colour = all[i]?.colour ?? look.text
    const scaled = (curve: Curve) => curve.map((value) => value && value * scale)
    return [
      ...(showMean.peek() ? [{ curve: scaled(mean), colour, kind: 'mean' as const }] : []),
      ...(showIterationBest.peek()
        ? [{ curve: scaled(iterationBest), colour, kind: 'iterationBest' as const }]
        : []),
      { curve: scaled(best), colour, kind: 'best' as const },
    ]
  })
  const references = levels().map(({ length, from }) => ({ length: length * scale, from }))
  const values = lines.flatMap(({ curve }) => curve.filter((value) => value !== null))
  const up = endsOf([...values, ...references.map(({ length }) => length)], scale)
  const across: Ends = [iterations[0] ?? 0, iterations.at(-1) ?? 1]
  const { whole, metres } = numbers.peek()
  const made = axes(
    BOX,
    { ends: across, label: t('chart.iteration'), write: (value) => whole.format(value) },
    {
      ends: up,
      label: withUnit(t(showsCost() ? 'chart.cost' : 'chart.length')),
      write: (value) => metres.format(value),
    },
    look,
    1,
  )
  const plot = element('g', {}, made.drawn)
  for (const each of references) plot.append(level(each, made, look))
  for (const line of lines) plot.append(curveOf(line, iterations, made))
  const looked = lookedAt.peek()
  if (looked !== null && looked >= across[0]) plot.append(mark(looked, made, look))
  const what = t('chart.title')
  return {
    drawing: { plot, height: HEIGHT, legend: legendOf(look), notes: [] },
    heading: headingOf(what),
    words: `${what}. ${all.map(({ label }) => label).join('; ')}`,
    look,
  }
}

function endsOf(values: number[], scale: number): Ends {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)]
  if (low > high) return [0, scale]
  const room = Math.max((high - low) * ROOM, high * 0.01, 0.5 * scale)
  return [low - room, high + room]
}

/** What is best stays so until something better is found; other curves go straight from value to value. */
function curveOf({ curve, colour, kind }: Line, iterations: number[], { x, y }: Axes): SVGElement {
  const points = curve.flatMap((value, i) =>
    value === null ? [] : [[px(x(iterations[i] ?? 0)), px(y(value))] as const],
  )
  const parts = points.map(([at, value], i) =>
    i === 0 ? `M${at} ${value}` : kind === 'best' ? `H${at}V${value}` : `L${at} ${value}`,
  )
  const [lone] = points
  if (points.length === 1 && lone)
    return element('circle', { cx: lone[0], cy: lone[1], r: 3.5, fill: colour, class: kind })
  return element('path', {
    d: parts.join(''),
    class: kind,
    fill: 'none',
    stroke: colour,
    'stroke-linejoin': 'round',
    ...LINES[kind],
  })
}

const level = ({ length, from }: { length: number; from: number }, { x, y }: Axes, look: Look) =>
  element('path', {
    d: `M${px(Math.max(BOX.left, x(from)))} ${px(y(length))}H${BOX.right}`,
    stroke: look.text,
    'stroke-width': 1.5,
    'stroke-dasharray': LEVEL_DASH,
  })

const mark = (iteration: number, { x }: Axes, look: Look) =>
  element('path', {
    d: `M${px(x(iteration))} ${BOX.top}V${BOX.bottom}`,
    stroke: look.muted,
    'stroke-width': 1.5,
  })

function legendOf(look: Look): LegendItem[] {
  const line = (label: string, colour: string, width: number, dash?: string): LegendItem => ({
    kind: 'line',
    label,
    colour,
    width,
    dash,
  })
  return [
    ...runners().map(({ label, colour }) => line(label, colour, 2.5)),
    ...(showIterationBest.peek() ? [line(t('chart.iterationBest'), look.muted, 1)] : []),
    ...(showMean.peek() ? [line(t('chart.mean'), look.muted, 1, MEAN_DASH)] : []),
    ...levels().map(({ objective, length }) => {
      const words = { length: lengthShown(length) }
      return line(t(`chart.levels.${objectiveWord(objective)}`, words), look.text, 1.5, LEVEL_DASH)
    }),
  ]
}
