/** Every run's value, with the quartiles; the exact optimum and published numbers are on the same scale. */

import type { Drawing, LegendItem } from '../../figures/frame'
import { plotSymbol } from '../../figures/point_symbols'
import { t } from '../../i18n/lab'
import { inTurn, listed, saying } from '../../i18n/lists'
import type { EntryAnalysis, Summary } from '../../model/analysis'
import { amount, dash, type ExactOptimum, labelOf, measureWords, optimaOf } from '../words/numbers'
import { type Box, boxMarks } from './box_marks'
import { DOTTED, drawPlot, gridX, MARGIN, POINT_RADIUS } from './draw_plot'
import { failures, MIDDLE, ROW, rowScale, rowTexts } from './entry_rows'
import { type Figure, type Plot, type Scene, type Shown, shownEntries } from './figure'
import { seriesOf } from './figure_style'
import { jitter, whiskers } from './whiskers_and_jitter'

/** Room for the name of the line across all rows, and for each further one. Pixels. */
const TOP = 22
const LABEL_LINE = 15
/** Part of a row by which equal values of different seeds are spread: to just below its name. */
const SPREAD = 0.28

export const values: Figure = {
  id: 'values',
  overall: false,
  suits: () => true,
  missing: ({ map }) =>
    rowsOf(map.entries).some(({ entry }) => entry.summary) ? null : 'lab.results.noPaths',
  draw,
  words: ({ map }) =>
    inTurn(
      rowsOf(map.entries).map((row) => {
        const { summary } = row.entry
        const median = t('lab.results.words.median', {
          value: dash(summary?.median, amount(map.measure)),
        })
        const parts = [saying(row.series.label, median), aside(row)]
        return listed(parts.filter((part) => part !== ''))
      }),
    ),
  table({ map }) {
    return {
      columns: [
        'entry',
        'least',
        'lower',
        'median',
        'upper',
        'greatest',
        'failures',
        'published',
      ].map((key) => t(`lab.results.columns.${key as 'entry'}`)),
      rows: rowsOf(map.entries).map(({ entry, series }) => [
        series.label,
        ...FIVE.map((key) => dash(entry.summary?.[key], amount(map.measure))),
        String(entry.runs - entry.with_path),
        dash(entry.published?.value, amount(map.measure)),
      ]),
    }
  },
}

const FIVE = ['least', 'lower', 'median', 'upper', 'greatest'] as const satisfies (keyof Summary)[]

/** Published numbers of what cannot be run have a row as well. */
function rowsOf(entries: EntryAnalysis[]): Shown[] {
  const runs = shownEntries({ entries } as Scene['map'])
  const published = entries.flatMap((entry, index) =>
    entry.runs === 0 && entry.published?.value != null
      ? [{ index, entry, series: seriesOf(index, labelOf(entry)) }]
      : [],
  )
  return [...runs, ...published].sort((a, b) => a.index - b.index)
}

function draw(plot: Plot, scene: Scene): Drawing {
  const { map } = scene
  const rows = rowsOf(map.entries)
  const optima = optimaOf(map)
  const top = TOP + LABEL_LINE * Math.max(0, optima.length - 1)
  const height = top + ROW * rows.length + MARGIN.bottom
  const picture = drawPlot(plot, scene, height, {
    marginTop: top,
    x: { nice: true },
    y: rowScale(rows.length),
    marks: [
      gridX(plot, scene, measureWords(map.measure)),
      optima.map((optimum, i) => optimumMarks(plot, scene, optimum, i)),
      rowTexts(
        plot,
        scene,
        rows.map((row) => ({ label: row.series.label, aside: aside(row) })),
      ),
      boxMarks(plot, scene, boxes(rows)),
      rows.map((row, i) => points(plot, row, i)),
      publishedMarks(plot, scene, rows),
    ],
  })
  const impossible = rows.some(({ entry }) => entry.published?.impossible)
  return {
    plot: picture,
    height,
    legend: legend(rows),
    notes: [t('lab.results.boxes'), ...(impossible ? [t('lab.results.impossibleNote')] : [])],
  }
}

const aside = (row: Shown) => (row.entry.runs === 0 ? t('lab.results.notRun') : failures(row))

function legend(rows: Shown[]): LegendItem[] {
  const published = rows.flatMap(({ entry }) =>
    entry.published?.value == null ? [] : [entry.published],
  )
  const item = (mark: 'published' | 'impossible' | 'box', label: string): LegendItem => ({
    kind: 'mark',
    mark,
    label,
  })
  return [
    item('box', t('lab.results.legend.box')),
    ...(published.some(({ impossible }) => !impossible)
      ? [item('published', t('lab.results.legend.published'))]
      : []),
    ...(published.some(({ impossible }) => impossible)
      ? [item('impossible', t('lab.results.legend.impossible'))]
      : []),
  ]
}

function optimumMarks(plot: Plot, { look }: Scene, { value, words }: ExactOptimum, place: number) {
  return [
    plot.ruleX([value], {
      stroke: look.text,
      ...DOTTED,
      className: 'optimum',
    }),
    plot.text([words], {
      x: [value],
      frameAnchor: 'top',
      text: (d: string) => d,
      dy: -13 - LABEL_LINE * place,
      lineAnchor: 'middle',
      textAnchor: 'start',
      dx: -2,
      fill: look.text,
    }),
  ]
}

function boxes(rows: Shown[]): Box[] {
  return rows.flatMap(({ entry, series: { colour } }, i) => {
    const { summary, values: all } = entry
    if (!summary) return []
    const { lower, median, upper } = summary
    return [{ i, colour, lower, median, upper, ...whiskers(all, summary) }]
  })
}

function points(plot: Plot, { entry, series }: Shown, row: number) {
  const found = entry.values.flatMap((value, i) =>
    value === null ? [] : [{ value, seed: entry.seeds[i] ?? i }],
  )
  return plot.dot(found, {
    x: 'value',
    y: ({ seed }) => row + MIDDLE + SPREAD * jitter(seed),
    r: POINT_RADIUS,
    symbol: plotSymbol(series.symbol),
    fill: series.colour,
    fillOpacity: 0.6,
    className: 'runs',
  })
}

function publishedMarks(plot: Plot, { look, map }: Scene, rows: Shown[]) {
  const all = rows.flatMap(({ entry: { published } }, i) =>
    published?.value == null
      ? []
      : [{ i, value: published.value, impossible: published.impossible }],
  )
  return plot.dot(all, {
    x: 'value',
    y: ({ i }) => i + MIDDLE,
    r: 6,
    symbol: plotSymbol('diamond'),
    fill: ({ impossible }) => (impossible ? look.bad : look.background),
    stroke: ({ impossible }) => (impossible ? look.bad : look.text),
    strokeWidth: 2,
    className: 'published',
    title: ({ value }) => t('lab.results.publishedIs', { value: amount(map.measure)(value) }),
  })
}
