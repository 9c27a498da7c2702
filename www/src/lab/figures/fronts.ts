/**
 * What runs trade off: each a point, each entry's front as steps. Of three measures two plots share the first one, without steps: of a front
 * in space no step can be seen in a plane.
 */

import type { Drawing } from '../../figures/frame'
import { plotSymbol } from '../../figures/point_symbols'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { inTurn, saying } from '../../i18n/lists'
import type { EntryFront, FrontPoint, MapFronts, Measure } from '../../model/analysis'
import { amount, dash, labelOf, measureWords, share } from '../words/numbers'
import { DOTTED, drawPlot, gridX, gridY } from './draw_plot'
import type { Figure, Plot, Scene } from './figure'
import { seriesOf } from './figure_style'

/** Pixels. */
const TALL = 340
const TOP = 26
const LEFT = 58
const RADIUS = { off: 2.6, own: 4.6 }
/** Part of the box that is left free around it, so that no point stands on an edge. */
const AIR = 0.05

interface ShownFront {
  index: number
  front: EntryFront
  label: string
}

export const fronts: Figure = {
  id: 'fronts',
  overall: false,
  suits: () => true,
  missing: (scene) =>
    frontsOf(scene).some(({ front }) => front.told > 0) ? null : 'lab.fronts.none',
  draw,
  words: (scene) =>
    inTurn(
      frontsOf(scene).map(({ front, label }) =>
        saying(
          label,
          t('lab.fronts.words', {
            volume: dash(front.hypervolume, volume),
            share: dash(front.share, share),
          }),
        ),
      ),
    ),
  table(scene) {
    const measures = scene.fronts?.measures ?? []
    return {
      columns: [
        t('lab.results.columns.entry'),
        ...measures.map(measureWords),
        t('lab.fronts.columns.pointRuns'),
        t('lab.fronts.columns.onJoint'),
      ],
      rows: frontsOf(scene).flatMap(({ front, label }) =>
        front.points
          .filter(({ own }) => own)
          .map(({ values, runs, joint }) => [
            label,
            ...values.map((value, i) => writer(measures[i])(value)),
            numbers.value.whole.format(runs),
            t(joint ? 'lab.fronts.yes' : 'lab.fronts.no'),
          ]),
      ),
    }
  },
}

/** A part of the box, with the digits that tell entries apart. */
export const volume = (part: number) =>
  new Intl.NumberFormat(numbers.value.whole.resolvedOptions().locale, {
    minimumFractionDigits: 4,
    maximumFractionDigits: 4,
  }).format(part)

export const writer = (measure: Measure | undefined) => amount(measure ?? 'length')

/** With what is better. */
export const sideWords = (fronts: MapFronts, place: number) =>
  t(fronts.more_is_better[place] ? 'lab.fronts.more' : 'lab.fronts.less', {
    measure: measureWords(fronts.measures[place] ?? 'length'),
  })

/** The entries of which there are runs. */
function frontsOf({ fronts: told, map }: Scene): ShownFront[] {
  return (told?.entries ?? []).flatMap((front) => {
    const entry = map.entries[front.entry]
    return entry && front.runs > 0 ? [{ index: front.entry, front, label: labelOf(entry) }] : []
  })
}

function draw(plot: Plot, scene: Scene): Drawing {
  const told = scene.fronts as MapFronts
  const shown = frontsOf(scene)
  const rest = told.measures.slice(1).map((_, i) => i + 1)
  const picture = document.createElementNS('http://www.w3.org/2000/svg', 'g')
  rest.forEach((upright, row) => {
    const one = panel(plot, scene, told, shown, upright)
    one.setAttribute('transform', `translate(0 ${row * TALL})`)
    picture.append(one)
  })
  const without = shown.filter(({ front }) => front.told < front.runs)
  const beyond = shown.some(({ front }) => front.beyond > 0)
  return {
    plot: picture,
    height: TALL * rest.length,
    legend: [
      ...shown
        .filter(({ front }) => front.told > 0)
        .map(({ index, label }) => ({
          kind: 'series' as const,
          series: seriesOf(index, label),
          line: rest.length === 1,
        })),
    ],
    notes: [
      t(rest.length === 1 ? 'lab.fronts.note' : 'lab.fronts.noteOfThree'),
      t('lab.fronts.referenceNote'),
      ...without.map(({ front, label }) =>
        t('lab.fronts.without', { entry: label, count: front.runs - front.told, runs: front.runs }),
      ),
      ...(beyond ? [t('lab.fronts.beyondNote')] : []),
    ],
  }
}

/** One plot: the first measure across, another one upright. */
function panel(plot: Plot, scene: Scene, told: MapFronts, shown: ShownFront[], upright: number) {
  const { look } = scene
  const at = (values: number[]) => ({ x: values[0] ?? 0, y: values[upright] ?? 0 })
  const flat = told.measures.length === 2
  const ring = (point: FrontPoint) => (point.joint ? look.text : look.background)
  return drawPlot(plot, scene, TALL, {
    marginTop: TOP,
    marginLeft: LEFT,
    x: { domain: reach(told, shown, 0) },
    y: { domain: reach(told, shown, upright) },
    marks: [
      gridX(plot, scene, sideWords(told, 0)),
      gridY(plot, scene, { label: sideWords(told, upright) }),
      referenceMarks(plot, scene, told, upright),
      flat ? shown.map((one) => steps(plot, told, one)) : [],
      shown.map(({ index, front }) => {
        const { colour, symbol } = seriesOf(index, '')
        return [false, true].map((own) =>
          plot.dot(
            front.points
              .filter((point) => point.own === own)
              .map((point) => ({ ...point, ...at(point.values) })),
            {
              x: 'x',
              y: 'y',
              r: own ? RADIUS.own : RADIUS.off,
              symbol: plotSymbol(symbol),
              fill: colour,
              fillOpacity: own ? 1 : 0.4,
              ...(own && { stroke: ring, strokeWidth: 1.5 }),
              className: own ? 'front-points' : 'points',
              title: (point: FrontPoint) => pointWords(told, point),
            },
          ),
        )
      }),
    ],
  })
}

/** What a point is, for who rests the pointer on it. */
function pointWords({ measures }: MapFronts, { values, runs }: FrontPoint): string {
  const parts = values.map((value, i) =>
    saying(measureWords(measures[i] ?? 'length'), writer(measures[i])(value)),
  )
  return `${inTurn(parts)} (${t('lab.fronts.runs', { count: runs })})`
}

/** From the best value to the reference, with what lies beyond it. */
function reach(told: MapFronts, shown: ShownFront[], place: number): [number, number] {
  const values = shown.flatMap(({ front }) => front.points.map((point) => point.values[place] ?? 0))
  const all = [...values, told.best[place] ?? 0, told.reference[place] ?? 0]
  const [least, most] = [Math.min(...all), Math.max(...all)]
  const air = AIR * Math.max(most - least, 1e-9)
  return [least - air, most + air]
}

/** Everything between a front and the reference is dominated: the edge of that. */
function steps(plot: Plot, told: MapFronts, { index, front }: ShownFront) {
  const [endX = 0, endY = 0] = told.reference
  const isWithin = (values: number[]) =>
    values.every((value, i) => {
      const worst = told.reference[i] ?? value
      return told.more_is_better[i] ? value > worst : value < worst
    })
  // The engine tells the best by the first measure first.
  const corners = front.points.filter(({ own, values }) => own && isWithin(values))
  const edge: { x: number; y: number }[] = []
  let y = endY
  for (const { values } of corners) {
    const x = values[0] ?? 0
    edge.push({ x, y })
    y = values[1] ?? y
    edge.push({ x, y })
  }
  if (edge.length > 0) edge.push({ x: endX, y })
  const { colour, dash: dashes } = seriesOf(index, '')
  return plot.line(edge, {
    x: 'x',
    y: 'y',
    stroke: colour,
    strokeWidth: 2,
    ...(dashes && { strokeDasharray: dashes }),
    className: 'front',
  })
}

function referenceMarks(plot: Plot, { look }: Scene, told: MapFronts, upright: number) {
  const [x = 0, y = 0] = [told.reference[0], told.reference[upright]]
  const line = { stroke: look.muted, ...DOTTED }
  const right = told.more_is_better[0] ? 'start' : 'end'
  return [
    plot.ruleX([x], { ...line, className: 'reference' }),
    plot.ruleY([y], { ...line, className: 'reference' }),
    plot.text([t('lab.fronts.reference')], {
      x: [x],
      y: [y],
      text: (words: string) => words,
      textAnchor: right,
      lineAnchor: told.more_is_better[upright] ? 'bottom' : 'top',
      dx: right === 'end' ? -6 : 6,
      dy: told.more_is_better[upright] ? -6 : 6,
      fill: look.muted,
      stroke: look.background,
      strokeWidth: 4,
    }),
  ]
}
