/** How many runs end how far above the best there is: one small histogram an entry, all on one scale. */

import { FONT } from '../../figures/look'
import { widthOf } from '../../figures/svg'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { inTurn, saying } from '../../i18n/lists'
import { drawPlot, LOW, MARGIN } from './draw_plot'
import { failures, rowScale, rowTexts } from './entry_rows'
import { type Figure, type Scene, type Shown, shownEntries } from './figure'

/** Pixels. */
const TALL = 92
/** Parts of a row: where bars stand and how high the highest is. */
const FOOT = 1
const HIGHEST = 0.5
/** Bins between the last one and the runs without a path: they are not on the scale. */
const APART = 1
const TICK_FONT = `11.5px ${FONT}`
/** Pixels between the words of two ticks. */
const BETWEEN = 10

interface Bar {
  row: number
  bin: number
  count: number
  colour: string
  /** Of runs that found nothing. */
  hollow: boolean
}

export const gaps: Figure = {
  id: 'gaps',
  overall: false,
  suits: () => true,
  missing({ map }) {
    if (map.gap_edges.length === 0) return 'lab.results.noReference'
    return shownEntries(map).some(({ entry }) => entry.gap) ? null : 'lab.results.noPaths'
  },
  draw(plot, scene) {
    const { map, look } = scene
    const rows = shownEntries(map).filter(({ entry }) => entry.gap || entry.with_path === 0)
    const bars = rows.flatMap(barsOf)
    const most = Math.max(1, ...bars.map(({ count }) => count))
    const heightOf = ({ count }: Bar) => (HIGHEST * count) / most
    const height = 4 + TALL * rows.length + MARGIN.bottom
    const failed = rows.some(({ entry }) => entry.with_path < entry.runs)
    const bins = map.gap_edges.length + (failed ? APART + 1 : 0)
    const picture = drawPlot(plot, scene, height, {
      marginTop: 4,
      x: { domain: [0, bins] },
      y: rowScale(rows.length),
      marks: [
        plot.axisX({
          ...LOW,
          label: t('lab.results.gapAxis'),
          ticks: ticksOf(scene, bins),
          color: look.muted,
          tickFormat: (place: number) => tickWords(place, scene),
        }),
        plot.ruleY([rows.length], { y: (d: number) => d, stroke: look.line }),
        [false, true].map((hollow) =>
          plot.rect(
            bars.filter((bar) => bar.count > 0 && bar.hollow === hollow),
            {
              x1: 'bin',
              x2: ({ bin }) => bin + 1,
              y1: ({ row }) => row + FOOT,
              y2: (bar) => bar.row + FOOT - heightOf(bar),
              insetLeft: 1.5,
              insetRight: 1.5,
              fill: 'colour',
              fillOpacity: hollow ? 0 : 0.75,
              ...(hollow && { stroke: look.bad, strokeDasharray: '3 2' }),
              className: hollow ? 'failed-bars' : 'bars',
            },
          ),
        ),
        plot.text(
          bars.filter(({ count }) => count > 0),
          {
            x: ({ bin }) => bin + 0.5,
            y: (bar) => bar.row + FOOT - heightOf(bar),
            dy: -7,
            text: ({ count }) => numbers.value.whole.format(count),
            fontSize: 11,
            fill: ({ hollow }) => (hollow ? look.bad : look.text),
            className: 'counts',
          },
        ),
        rowTexts(
          plot,
          scene,
          rows.map((row) => ({ label: row.series.label, aside: failures(row) })),
        ),
      ],
    })
    return {
      plot: picture,
      height,
      legend: [],
      notes: [t('lab.results.gapsNote'), ...(failed ? [t('lab.results.gapsFailedNote')] : [])],
    }
  },
  words: ({ map }) =>
    inTurn(
      shownEntries(map).map(({ entry, series }) => {
        const counts = { optimal: entry.optimal, runs: entry.runs }
        return saying(series.label, t('lab.results.words.optimal', counts))
      }),
    ),
  table({ map }) {
    const edges = map.gap_edges.map((edge) => numbers.value.share.format(edge))
    const bins = edges.map((edge, i) =>
      i + 1 < edges.length ? `${edge} – ${edges[i + 1]}` : `≥ ${edge}`,
    )
    return {
      columns: [t('lab.results.columns.entry'), ...bins, t('lab.results.noPath')],
      rows: shownEntries(map).map(({ entry, series }) => [
        series.label,
        ...entry.gap_counts.map(String),
        String(entry.runs - entry.with_path),
      ]),
    }
  },
}

/** The last bin that the engine counts has no upper end; after it stand the runs without a path. */
function barsOf({ entry, series }: Shown, row: number): Bar[] {
  const counted = entry.gap_counts.map((count, bin) => ({
    row,
    bin,
    count,
    colour: series.colour,
    hollow: false,
  }))
  const failed = {
    row,
    bin: entry.gap_counts.length + APART,
    count: entry.runs - entry.with_path,
    colour: series.colour,
    hollow: true,
  }
  return [...counted, failed]
}

/** Edges of bins, back from the last one, as many as have room beside each other; then the runs without a path, if there are any. */
function ticksOf(scene: Scene, bins: number): number[] {
  const edges = scene.map.gap_edges.map((_, i) => i)
  const widest = Math.max(...edges.map((i) => widthOf(tickWords(i, scene), TICK_FONT)))
  const wide = (scene.width - MARGIN.left - MARGIN.right) / bins
  const stride = Math.ceil((widest + BETWEEN) / wide)
  const shown = edges.filter((i) => (edges.length - 1 - i) % stride === 0)
  return bins > edges.length ? [...shown, bins - 0.5] : shown
}

/** The last bin has no upper end. */
function tickWords(place: number, { map }: Scene): string {
  const [edge, last] = [map.gap_edges[place], map.gap_edges.length - 1]
  if (edge === undefined) return t('lab.results.noPathShort')
  const words = numbers.value.share.format(edge)
  return place === last ? `≥ ${words}` : words
}
