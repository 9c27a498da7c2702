/** What it takes each entry to find its best path. */
import { t } from '../../i18n/lab'
import { inTurn, saying } from '../../i18n/lists'
import type { Summary } from '../../model/analysis'
import { axisWords, dash, effort as effortOf } from '../words/numbers'
import { type Box, boxMarks } from './box_marks'
import { drawPlot, effortScale, gridEffort, MARGIN } from './draw_plot'
import { timeNote } from './effort_curves'
import { failures, ROW, rowScale, rowTexts } from './entry_rows'
import { type Figure, type Scene, type Shown, shownEntries } from './figure'

const FIVE = ['least', 'lower', 'median', 'upper', 'greatest'] as const satisfies (keyof Summary)[]

/** On a logarithmic scale boxes begin above 0. */
function known(scene: Scene): (Shown & { summary: Summary })[] {
  return shownEntries(scene.map).flatMap((each) => {
    const summary = each.entry.effort_to_best
    return summary && (!scene.logarithmic || summary.greatest > 0) ? [{ ...each, summary }] : []
  })
}

export const effort: Figure = {
  id: 'effort',
  overall: false,
  suits: () => true,
  missing(scene) {
    if (known(scene).length > 0) return null
    if (!scene.map.entries.some(({ with_path }) => with_path > 0)) return 'lab.results.noPaths'
    return scene.analysis.axis === 'time' ? 'lab.results.noTimes' : 'lab.results.noEffort'
  },
  draw(plot, scene) {
    const rows = known(scene)
    const least = Math.min(
      ...rows.flatMap(({ summary }) => FIVE.map((key) => summary[key]).filter((v) => v > 0)),
    )
    const at = (v: number) => (scene.logarithmic ? Math.max(v, least) : v)
    const boxes = rows.map(({ series, summary }, i): Box => {
      const { least, lower, median, upper, greatest } = summary
      return {
        i,
        colour: series.colour,
        low: at(least),
        lower: at(lower),
        median: at(median),
        upper: at(upper),
        high: at(greatest),
      }
    })
    const height = 8 + ROW * rows.length + MARGIN.bottom
    const picture = drawPlot(plot, scene, height, {
      marginTop: 8,
      x: effortScale(scene),
      y: rowScale(rows.length),
      marks: [
        gridEffort(plot, scene),
        rowTexts(
          plot,
          scene,
          rows.map((row) => ({ label: row.series.label, aside: failures(row) })),
        ),
        boxMarks(plot, scene, boxes),
      ],
    })
    return {
      plot: picture,
      height,
      legend: [{ kind: 'mark', mark: 'box', label: t('lab.results.legend.box') }],
      notes: [t('lab.results.effortNote'), ...timeNote(scene)],
    }
  },
  words: (scene) =>
    inTurn(
      known(scene).map(({ series, summary }) => {
        const value = effortOf(scene.analysis.axis)(summary.median)
        return saying(series.label, t('lab.results.words.median', { value }))
      }),
    ),
  table(scene) {
    return {
      columns: [
        t('lab.results.columns.entry'),
        ...FIVE.map(
          (key) => `${t(`lab.results.columns.${key}`)} (${axisWords(scene.analysis.axis)})`,
        ),
      ],
      rows: known(scene).map(({ series, summary }) => [
        series.label,
        ...FIVE.map((key) => dash(summary[key], effortOf(scene.analysis.axis))),
      ]),
    }
  },
}
