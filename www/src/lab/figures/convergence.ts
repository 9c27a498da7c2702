/** How good the best path is after so much effort: median and quartiles of the runs. */

import type { LegendItem } from '../../figures/frame'
import { t } from '../../i18n/lab'
import { inTurn, listed, saying } from '../../i18n/lists'
import type { BandPoint, EntryAnalysis } from '../../model/analysis'
import { amount, dash, type ExactOptimum, effort, measureWords, optimaOf } from '../words/numbers'
import { type Ends, endsOf, limitsOf, placed } from './curve_limits'
import { DOTTED, drawPlot, effortScale, gridEffort, gridY } from './draw_plot'
import {
  curve,
  curveColumns,
  finished,
  heightOf,
  LEFT,
  missingCurves,
  shownWith,
  TOP,
} from './effort_curves'
import type { Figure, Plot, Scene, Shown } from './figure'

/** Rows of a curve's table: as many as one reads. */
const MOST_ROWS = 12

export const convergence: Figure = {
  id: 'convergence',
  overall: false,
  suits: () => true,
  missing: (scene) => missingCurves(scene, hasBand),
  draw(plot, scene) {
    const shown = shownWith(scene, hasBand)
    const { curve_measure: measure } = scene.map
    const optima = optimaOf(scene.map, measure)
    const bands = shown.map(({ entry }) => entry.band)
    const limits = limitsOf(
      bands,
      optima.map(({ value }) => value),
    )
    const inSight = bands.flat().filter(({ lower }) => lower !== null && lower <= limits.high)
    const ends = endsOf(
      inSight.map(({ x }) => x),
      scene.logarithmic,
    )
    const picture = drawPlot(plot, scene, heightOf(scene), {
      marginLeft: LEFT,
      marginTop: TOP,
      x: effortScale(scene),
      y: { domain: [limits.low, limits.high] },
      marks: [
        gridEffort(plot, scene),
        gridY(plot, scene, { label: measureWords(measure) }),
        shown.map((each) => band(plot, each, ends, limits.most, shade(shown.length))),
        optima.map((each) => optimum(plot, scene, each)),
        shown.map((each) => curve(plot, each, placed(each.entry.band, ends), 'median', ends)),
      ],
    })
    const cut = { value: amount(measure)(limits.high) }
    return finished(scene, {
      plot: picture,
      shown,
      legend: legend(optima),
      notes: [
        t('lab.results.convergenceNote'),
        ...(limits.most > limits.high ? [t('lab.results.cut', cut)] : []),
      ],
    })
  },
  words: (scene) =>
    inTurn(
      shownWith(scene, hasBand).map(({ entry, series }) => {
        const value = dash(entry.band.at(-1)?.median, amount(scene.map.curve_measure))
        return saying(series.label, t('lab.results.words.median', { value }))
      }),
    ),
  table(scene) {
    const words = amount(scene.map.curve_measure)
    const spent = effort(scene.analysis.axis)
    const quartiles = (['lower', 'median', 'upper'] as const).map((key) =>
      t(`lab.results.columns.${key}`),
    )
    return {
      columns: curveColumns(scene, ...quartiles),
      rows: shownWith(scene, hasBand).flatMap(({ entry, series }) =>
        thinned(entry.band).map(({ x, lower, median, upper }) => [
          series.label,
          spent(x),
          ...[lower, median, upper].map((value) => dash(value, words)),
        ]),
      ),
    }
  },
}

const hasBand = ({ band }: EntryAnalysis) => band.some(({ lower }) => lower !== null)

/** Faint, so that curves stand out from many overlapping bands. */
const shade = (bands: number) => Math.min(0.14, 0.8 / bands)

/** Where less than three quarters of the runs have a path, the upper quartile is beyond every length. */
function band(plot: Plot, { entry, series }: Shown, ends: Ends, most: number, shade: number) {
  return plot.areaY(placed(entry.band, ends), {
    x: 'x',
    y1: 'lower',
    y2: ({ lower, upper }: BandPoint) => upper ?? (lower === null ? null : most),
    curve: 'step-after',
    fill: series.colour,
    fillOpacity: shade,
    clip: true,
    className: 'bands',
  })
}

function optimum(plot: Plot, { look }: Scene, { value }: ExactOptimum) {
  return plot.ruleY([value], {
    stroke: look.text,
    ...DOTTED,
    className: 'optimum',
  })
}

function legend(optima: ExactOptimum[]): LegendItem[] {
  const band = t('lab.results.legend.band')
  const lines = listed(optima.map(({ words }) => words))
  return [
    { kind: 'mark', mark: 'band', label: band },
    ...(lines === '' ? [] : [{ kind: 'mark', mark: 'optimum', label: lines } as const]),
  ]
}

function thinned<P>(points: P[]): P[] {
  const stride = Math.max(1, Math.ceil(points.length / MOST_ROWS))
  return points.filter((_, i) => i % stride === 0 || i === points.length - 1)
}
