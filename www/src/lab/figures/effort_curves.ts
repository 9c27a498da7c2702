/** What all figures with curves over effort share. */

import type { Drawing, LegendItem } from '../../figures/frame'
import { plotSymbol } from '../../figures/point_symbols'
import { t } from '../../i18n/lab'
import { inTurn, listed, saying } from '../../i18n/lists'
import type { EntryAnalysis } from '../../model/analysis'
import { axisWords } from '../words/numbers'
import type { Ends } from './curve_limits'
import { failures } from './entry_rows'
import { type Plot, type Scene, type Shown, shownEntries } from './figure'

/** Room for the numbers beside a plot, and for the name above them. Pixels. */
export const LEFT = 52
export const TOP = 26

export const heightOf = ({ width }: Scene) => Math.round(Math.max(240, Math.min(360, 0.56 * width)))

export const shownWith = ({ map }: Scene, has: (entry: EntryAnalysis) => boolean) =>
  shownEntries(map).filter(({ entry }) => has(entry))

/**
 * Efforts on this axis may be unknown though there are paths: of imported results, or of times in an opened file.
 */
export function missingCurves(scene: Scene, has: (entry: EntryAnalysis) => boolean) {
  if (shownWith(scene, has).length > 0) return null
  if (!scene.map.entries.some(({ with_path }) => with_path > 0)) return 'lab.results.noPaths'
  return scene.analysis.axis === 'time' ? 'lab.results.noTimes' : 'lab.results.noEffort'
}

/** Steps, the entry's symbol where its longest run ended, and a thin line from there on: what was found stays found. */
export function curve<P extends { x: number }>(
  plot: Plot,
  { series }: Shown,
  points: P[],
  y: keyof P & string,
  { last: edge }: Ends,
) {
  const last = points.filter((point) => point[y] !== null).slice(-1)
  const after = last.flatMap((point) => [point, { ...point, x: edge }])
  const line = {
    x: 'x',
    y,
    stroke: series.colour,
    strokeDasharray: series.dash,
    clip: true,
  } as const
  return [
    plot.line(points, {
      ...line,
      curve: 'step-after',
      strokeWidth: 2.25,
      strokeLinejoin: 'round',
      className: 'curves',
    }),
    plot.line(after, { ...line, strokeWidth: 1, strokeOpacity: 0.7, className: 'afterwards' }),
    plot.dot(last, {
      x: 'x',
      y,
      r: 4,
      symbol: plotSymbol(series.symbol),
      fill: series.colour,
      className: 'ends',
    }),
  ]
}

interface Finish {
  plot: SVGElement
  shown: Shown[]
  legend: LegendItem[]
  notes: string[]
}

export function finished(scene: Scene, { plot, shown, legend, notes }: Finish): Drawing {
  const series = shown.map(
    (each): LegendItem => ({ kind: 'series', series: each.series, line: true }),
  )
  const left = shownEntries(scene.map).filter(
    ({ index }) => !shown.some((each) => each.index === index),
  )
  const entries = listed(left.map((each) => each.series.label))
  return {
    plot,
    height: heightOf(scene),
    legend: [...series, ...legend],
    notes: [
      ...notes,
      t('lab.results.endsNote'),
      ...pathless(shown),
      ...(left.length > 0 ? [t('lab.results.leftOut', { entries })] : []),
      ...timeNote(scene),
    ],
  }
}

/** Notes on failed runs, which a curve cannot show. */
export function pathless(shown: Shown[]): string[] {
  const said = shown
    .map((each) => ({ label: each.series.label, words: failures(each) }))
    .filter(({ words }) => words !== '')
  const all = inTurn(said.map(({ label, words }) => saying(label, words)))
  return said.length === 0 ? [] : [t('lab.results.sentence', { words: all })]
}

export const timeNote = ({ analysis }: Scene) =>
  analysis.axis === 'time' ? [t('lab.results.timeNote')] : []

/** Its columns: the entry, the effort, and what the curve tells. */
export const curveColumns = ({ analysis }: Scene, ...more: string[]) => [
  t('lab.results.columns.entry'),
  axisWords(analysis.axis),
  ...more,
]
