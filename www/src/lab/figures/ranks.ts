/** Mean ranks over all maps, as Demšar (2006) draws them, with Holm's correction in place of one critical difference. */

import { plotSymbol } from '../../figures/point_symbols'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { inTurn, saying } from '../../i18n/lists'
import type { EntryAnalysis, Ranks } from '../../model/analysis'
import { chance, labelOf, significant } from '../words/numbers'
import { drawPlot, LOW, MARGIN } from './draw_plot'
import { MIDDLE, rowScale, rowTexts } from './entry_rows'
import type { Figure, Scene } from './figure'
import { seriesOf } from './figure_style'
import { groups } from './rank_groups'
import { jitter } from './whiskers_and_jitter'

/** Pixels. */
const TALL = 46
const COLUMN = 14
/** Of the numbers of ranks, two digits and what is between them. */
const TICK = 24

interface Ranked {
  entry: number
  label: string
  mean: number
  byMap: number[]
}

/** Best first. */
export function ranked(analysis: Scene['analysis'], ranks: Ranks): Ranked[] {
  const entries = analysis.instances[0]?.entries ?? []
  const all = ranks.entries.map((entry, place) => ({
    entry,
    label: nameOf(entries[entry]),
    mean: ranks.mean_ranks[place] ?? 0,
    byMap: ranks.by_map.map((map) => map[place] ?? 0),
  }))
  return all.sort((a, b) => a.mean - b.mean)
}

const nameOf = (entry: EntryAnalysis | undefined) => (entry ? labelOf(entry) : '')

export const ranks: Figure = {
  id: 'ranks',
  overall: true,
  suits: () => true,
  missing({ analysis }) {
    if (analysis.ranks) return null
    return analysis.instances.length < 2 ? 'lab.results.oneMap' : 'lab.results.noRanks'
  },
  draw(plot, scene) {
    const { analysis, look, width } = scene
    const all = analysis.ranks as Ranks
    const order = ranked(analysis, all)
    const bars = groups(order, all)
    const right = MARGIN.right + COLUMN * bars.length + (bars.length > 0 ? 6 : 0)
    const height = 4 + TALL * order.length + MARGIN.bottom
    const apart = (width - MARGIN.left - right) / Math.max(1, order.length - 1)
    const stride = Math.ceil(TICK / apart)
    const symbols = order.map(({ entry, label, mean, byMap }, i) => {
      const series = seriesOf(entry, label)
      const y = i + MIDDLE
      return [
        plot.ruleY([y], { y: (d: number) => d, stroke: look.line }),
        plot.dot(byMap, {
          x: (d: number) => d,
          y: (_, map) => y + 0.13 * jitter(map + 1),
          r: 2.6,
          fill: series.colour,
          fillOpacity: 0.45,
          className: 'by-map',
        }),
        plot.dot([mean], {
          x: (d: number) => d,
          y: [y],
          r: 6,
          symbol: plotSymbol(series.symbol),
          fill: series.colour,
          stroke: look.background,
          strokeWidth: 1.5,
          className: 'mean-ranks',
        }),
      ]
    })
    const picture = drawPlot(plot, scene, height, {
      marginTop: 4,
      marginRight: right,
      x: { domain: [1, order.length] },
      y: rowScale(order.length),
      marks: [
        plot.axisX({
          ticks: order.map((_, i) => i + 1).filter((_, i) => i % stride === 0),
          tickFormat: (d: number) => numbers.value.whole.format(d),
          ...LOW,
          label: t('lab.results.rankAxis'),
          color: look.muted,
        }),
        rowTexts(
          plot,
          { ...scene, width: width - right },
          order.map(({ label, mean }) => ({
            label,
            aside: numbers.value.length.format(mean),
            tone: 'plain' as const,
          })),
        ),
        symbols,
        bars.map(([from, to], i) =>
          plot.ruleX([order.length], {
            x: (d: number) => d,
            dx: 12 + COLUMN * i,
            y1: [from + MIDDLE - 0.18],
            y2: [to + MIDDLE + 0.18],
            stroke: look.text,
            strokeWidth: 4,
            strokeLinecap: 'round',
            className: 'groups',
          }),
        ),
      ],
    })
    const test = t('lab.results.friedman', {
      statistic: significant(all.statistic),
      degrees: all.degrees,
      p: chance(all.p),
      maps: all.maps,
    })
    return {
      plot: picture,
      height,
      legend: [
        { kind: 'mark', mark: 'map', label: t('lab.results.legend.map') },
        ...(bars.length > 0
          ? [{ kind: 'mark', mark: 'group', label: t('lab.results.legend.group') } as const]
          : []),
      ],
      notes: [test, t('lab.results.ranksNote')],
    }
  },
  words: ({ analysis }) =>
    inTurn(
      ranked(analysis, analysis.ranks as Ranks).map(({ label, mean }) =>
        saying(label, numbers.value.length.format(mean)),
      ),
    ),
  table({ analysis }) {
    const all = analysis.ranks as Ranks
    return {
      columns: [
        t('lab.results.columns.entry'),
        t('lab.results.columns.meanRank'),
        ...analysis.instances.map(({ name }) => name),
      ],
      rows: ranked(analysis, all).map(({ label, mean, byMap }) => [
        label,
        numbers.value.length.format(mean),
        ...byMap.map(significant),
      ]),
    }
  },
}
