/** The share of (run, target) pairs solved after so much effort: an empirical distribution of running times over several targets. */
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { inTurn, listed, saying } from '../../i18n/lists'
import type { EntryAnalysis } from '../../model/analysis'
import { dash, effort, optimaOf } from '../words/numbers'
import { type Ends, endsOf, placed } from './curve_limits'
import { drawPlot, effortScale, gridEffort, gridY } from './draw_plot'
import { curve, finished, heightOf, LEFT, missingCurves, shownWith, TOP } from './effort_curves'
import type { Figure } from './figure'

export const targets: Figure = {
  id: 'targets',
  overall: false,
  suits: () => true,
  missing: (scene) =>
    scene.map.targets.length === 0 ? 'lab.results.noReference' : missingCurves(scene, hasSteps),
  draw(plot, scene) {
    const shown = shownWith(scene, hasSteps)
    const efforts = shown.flatMap(({ entry }) => [
      ...entry.ecdf.map(({ x }) => x),
      entry.total_effort?.greatest ?? 0,
    ])
    const ends = endsOf(efforts, scene.logarithmic)
    const picture = drawPlot(plot, scene, heightOf(scene), {
      marginLeft: LEFT,
      marginTop: TOP,
      x: effortScale(scene),
      y: { domain: [0, 1] },
      marks: [
        gridEffort(plot, scene),
        gridY(plot, scene, { label: t('lab.results.solved'), percent: true }),
        shown.map((each) => curve(plot, each, stepsOf(each.entry, ends), 'share', ends)),
      ],
    })
    const gaps = listed(scene.map.target_gaps.map((gap) => numbers.value.share.format(gap)))
    const proven = optimaOf(scene.map, scene.map.curve_measure).length > 0
    const notes = [t(proven ? 'lab.results.targetsNote' : 'lab.results.targetsKnownNote', { gaps })]
    return finished(scene, { plot: picture, shown, legend: [], notes })
  },
  words: (scene) =>
    inTurn(
      shownWith(scene, hasSteps).map(({ entry, series }) =>
        saying(series.label, numbers.value.share.format(entry.ecdf.at(-1)?.share ?? 0)),
      ),
    ),
  table(scene) {
    const spent = effort(scene.analysis.axis)
    const within = (gap: number) =>
      t('lab.results.withinGap', { gap: numbers.value.share.format(gap) })
    return {
      columns: [t('lab.results.columns.entry'), ...scene.map.target_gaps.map(within)],
      rows: shownWith(scene, hasSteps).map(({ entry, series }) => [
        series.label,
        ...entry.running_times.map(({ successes, expected }) => {
          const found = { count: successes, runs: entry.runs }
          return expected === null
            ? t('lab.results.of', { part: successes, whole: entry.runs })
            : t('lab.results.hits', { ...found, effort: dash(expected, spent) })
        }),
      ]),
    }
  },
}

const hasSteps = ({ ecdf }: EntryAnalysis) => ecdf.length > 0

/** From nothing solved at the left end on, to where the last run ended. */
function stepsOf({ ecdf, total_effort }: EntryAnalysis, ends: Ends) {
  const last = ecdf.at(-1)
  const end = total_effort?.greatest ?? 0
  const until = last && end > last.x ? [{ x: end, share: last.share }] : []
  return [{ x: ends.first, share: 0 }, ...placed([...ecdf, ...until], ends)]
}
