/** What each component of a planner does: differences between runs without it and runs of the full planner, with equal seeds. */

import { plotSymbol } from '../../figures/point_symbols'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { inTurn, saying } from '../../i18n/lists'
import type { Ablated, Difference, Effect } from '../../model/analysis'
import { amount, chance, dash, measureWords } from '../words/numbers'
import { drawPlot, gridX, MARGIN } from './draw_plot'
import { pathless } from './effort_curves'
import { MIDDLE, ROW, rowScale, rowTexts } from './entry_rows'
import { type Figure, type Plot, type Scene, shownEntries } from './figure'
import { seriesOf } from './figure_style'

const TOP = 20

interface Row {
  effect: Effect
  label: string
  /** By the statistic that decides; null where runs without a path leave no finite one. */
  difference: Difference | null
}

function ablated({ analysis, map }: Scene): Ablated | undefined {
  return analysis.ablation.find(({ instance }) => analysis.instances[instance]?.id === map.id)
}

function rowsOf(scene: Scene): Row[] {
  const found = ablated(scene)
  return (found?.effects ?? []).map((effect) => {
    const difference = (found?.statistic === 'mean' ? effect.means : effect.medians) ?? null
    const usable =
      difference !== null && [difference.value, difference.low, difference.high].every(isNumber)
    return {
      effect,
      label: scene.map.entries[effect.entry]?.label ?? effect.name,
      difference: usable ? difference : null,
    }
  })
}

const isNumber = (value: number | null) => value !== null && Number.isFinite(value)

export const ablation: Figure = {
  id: 'ablation',
  overall: false,
  suits: ({ instances }) =>
    instances[0]?.entries.some(({ ablation_role }) => ablation_role !== null) ?? false,
  missing(scene) {
    if (rowsOf(scene).some(({ effect }) => effect.pairs > 0)) return null
    const rests = scene.analysis.ablation.length > 0
    return rests ? 'lab.results.noPaths' : 'lab.results.intervalsWait'
  },
  draw(plot, scene) {
    const rows = rowsOf(scene)
    const height = TOP + ROW * rows.length + MARGIN.bottom
    const { look } = scene
    const all = rows.flatMap(({ difference, effect }, i) =>
      difference ? [{ i, ...difference, colour: seriesOf(effect.entry, '').colour }] : [],
    )
    const statistic = t(`lab.results.statistics.${ablated(scene)?.statistic ?? 'mean'}`)
    const picture = drawPlot(plot, scene, height, {
      marginTop: TOP,
      x: {
        domain: bothSides(all.flatMap(({ low, high }) => [low, high])),
        tickFormat: '+',
      },
      y: rowScale(rows.length),
      marks: [
        gridX(
          plot,
          scene,
          t('lab.results.ablationAxis', {
            measure: measureWords(ablated(scene)?.measure ?? 'length'),
            statistic,
          }),
        ),
        plot.ruleX([0], { stroke: look.text, strokeWidth: 1.5 }),
        sides(plot, scene),
        rowTexts(
          plot,
          scene,
          rows.map(({ label, effect, difference }) => ({
            label,
            aside: difference
              ? t(`lab.results.findings.${effect.finding}`)
              : `${lost(effect)}; ${t(`lab.results.findings.${effect.finding}`)}`,
            tone: 'plain' as const,
          })),
        ),
        plot.ruleY(all, {
          y: ({ i }) => i + MIDDLE,
          x1: 'low',
          x2: 'high',
          stroke: 'colour',
          strokeWidth: 3,
          strokeLinecap: 'round',
          className: 'intervals',
        }),
        plot.dot(all, {
          y: ({ i }) => i + MIDDLE,
          x: 'value',
          r: 5.5,
          symbol: plotSymbol('circle'),
          fill: 'colour',
          stroke: look.background,
          strokeWidth: 1.5,
          className: 'effects',
        }),
      ],
    })
    return {
      plot: picture,
      height,
      legend: [],
      notes: [t('lab.results.ablationNote', { statistic }), ...pathless(shownEntries(scene.map))],
    }
  },
  words: (scene) =>
    inTurn(
      rowsOf(scene).map(({ label, effect }) =>
        saying(label, t(`lab.results.findings.${effect.finding}`)),
      ),
    ),
  table(scene) {
    const measure = amount(ablated(scene)?.measure ?? 'length')
    return {
      columns: (['component', 'difference', 'interval', 'chance', 'finding'] as const).map((key) =>
        t(`lab.results.columns.${key}`),
      ),
      rows: rowsOf(scene).map(({ label, effect, difference }) => [
        label,
        difference ? signed(difference.value, measure) : lost(effect),
        difference
          ? `${signed(difference.low, measure)} … ${signed(difference.high, measure)}`
          : '–',
        dash(effect.holm, chance),
        t(`lab.results.findings.${effect.finding}`),
      ]),
    }
  },
}

/** 0 lies well inside the axis, with room for words on either side. */
function bothSides(ends: number[]): [number, number] {
  const [least, most] = [Math.min(0, ...ends), Math.max(0, ...ends)]
  const span = Math.max(most - least, 1e-9)
  return [Math.min(least - 0.05 * span, -0.2 * span), Math.max(most + 0.05 * span, 0.2 * span)]
}

/** Where too many runs find nothing, no length says how much is lost. */
const lost = ({ success }: Effect) =>
  t('lab.results.lostPaths', { points: numbers.value.percent.format(success) })

const signed = (value: number, write: (value: number) => string) =>
  `${value < 0 ? '−' : value > 0 ? '+' : ''}${write(Math.abs(value))}`

/** What it means to lie on one side of 0. */
function sides(plot: Plot, { look }: Scene) {
  const text = (anchor: 'left' | 'right', words: string) =>
    plot.text([words], {
      frameAnchor: anchor === 'left' ? 'top-left' : 'top-right',
      text: (d: string) => d,
      dy: -14,
      lineAnchor: 'middle',
      textAnchor: anchor === 'left' ? 'start' : 'end',
      fill: look.muted,
    })
  return [
    text('left', `← ${t('lab.results.betterWithout')}`),
    text('right', `${t('lab.results.worseWithout')} →`),
  ]
}
