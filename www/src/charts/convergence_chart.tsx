/** The chart of convergence with its cursor, whose values stand above it. */
import '../styles/charts.css'
import { effect, useComputed } from '@preact/signals'
import type uPlot from 'uplot'
import { numbers } from '../i18n'
import { addReadingWords, t } from '../i18n/reading'
import { lastIteration, lookTo } from '../playback/look_back'
import { liveTick, lookedAt, panels, slotColour, theme } from '../state'
import { lengthShown } from '../words/lengths'
import { metresPerCell, withUnit } from '../words/metres'
import { objectiveWord } from '../words/objective_words'
import { panelTitle } from '../words/planner_words'
import { ChartCursor } from './chart_cursor'
import { ChartFrame } from './chart_frame'
import { keepFitting } from './chart_style'
import { curvesOf, type Reached, reachedAt } from './convergence_data'
import { makePlot, type PlotStyle, plotData } from './convergence_plot'
import { CurveToggles } from './curve_toggles'
import { levels, showIterationBest, showMean, showsCost } from './shown_curves'

const ready = () => addReadingWords()
export const fetchChart = () => ready().then(() => ConvergenceChart)

/** Curves are redrawn no more often than a reader can follow. */
const REDRAW_MS = 160

const first = () => Math.min(1, lastIteration.peek())

const cursor = new ChartCursor({
  ends: () => [first(), lastIteration.peek()],
  nearest: (x) => Math.min(lastIteration.peek(), Math.max(first(), Math.round(x))),
  step: (from, by) => Math.min(lastIteration.peek(), Math.max(first(), from + by)),
  start: () => lookedAt.peek() ?? lastIteration.peek(),
  act: lookTo,
})

/** What the readout is about: the place of the cursor, else the iteration that is on show. */
const iterationNow = () => cursor.at.value ?? lookedAt.value ?? lastIteration.value

function ConvergenceChart() {
  const label = useComputed(() => t('cursor.convergence', { chart: t('chart.title') }))
  const iteration = iterationNow()
  liveTick.value
  const reached = panels.value.map((panel) => ({ panel, ...reachedAt(panel, iteration) }))
  const words = reached.map(({ panel, ...values }) => inWords(panelTitle(panel.id), values))
  const at = t('cursor.iteration', { iteration: numbers.value.whole.format(iteration) })
  return (
    <>
      <div class="chart-readout" data-testid="chart-readout" data-iteration={iteration}>
        <table>
          <thead>
            <tr>
              <th scope="col">{at}</th>
              <th scope="col">{t('cursor.best')}</th>
              <th scope="col">{t('chart.iterationBest')}</th>
              <th scope="col">{t('chart.mean')}</th>
            </tr>
          </thead>
          <tbody>
            {reached.map(({ panel: { id, slot, live }, best, iterationBest, mean }) => (
              <tr key={id} style={{ '--panel-colour': slotColour(slot) }}>
                <th scope="row">
                  <span class="line-sample best" aria-hidden="true" />
                  {panelTitle(id)}
                  {/* What the search found; the panel has the refined path. */}
                  {(live.value.summary?.unrefined_length ?? null) !== null && (
                    <span class="hint"> · {t('metrics.unrefinedLength')}</span>
                  )}
                </th>
                <td>{written(best)}</td>
                <td>{written(iterationBest)}</td>
                <td>{written(mean)}</td>
              </tr>
            ))}
            <References />
          </tbody>
        </table>
      </div>
      <CurveToggles />
      <ChartFrame
        testId="chart"
        picture="convergence"
        cursor={cursor}
        label={label}
        ends={[first(), lastIteration.value]}
        at={iteration}
        words={[at, ...words].join('; ')}
        keepDrawn={keepDrawn}
      />
    </>
  )
}

function References() {
  return (
    <>
      {levels().map(({ objective, length }) => (
        <tr key={objective} data-testid="chart-optimum">
          <th scope="row" colSpan={4}>
            <span class="line-sample optimum" aria-hidden="true" />
            {t(`chart.levels.${objectiveWord(objective)}`, { length: written(length) })}
          </th>
        </tr>
      ))}
    </>
  )
}

const written = (value: number | null) => (value === null ? '–' : lengthShown(value))

function inWords(planner: string, { best, iterationBest, mean }: Reached): string {
  const values = { planner, best: written(best) }
  if (iterationBest === null || mean === null) return t('cursor.bestOf', values)
  return t('cursor.valuesOf', {
    ...values,
    iterationBest: written(iterationBest),
    mean: written(mean),
  })
}

/** Makes the plot anew when its lines change, and refills it, at most every REDRAW_MS, when runs go on. */
function keepDrawn(host: HTMLElement): () => void {
  let plot: uPlot | null = null
  let style = plotStyle()
  let timer = 0
  const refill = () => {
    timer = 0
    plot?.setData(plotData(curvesOf(panels.peek()), style))
    cursor.refresh()
  }
  const stopRemaking = effect(() => {
    style = plotStyle()
    plot?.destroy()
    plot = makePlot(host, style, cursor)
    refill()
  })
  const stopRefilling = effect(() => {
    liveTick.value
    if (timer === 0) timer = window.setTimeout(refill, REDRAW_MS)
  })
  const stopMarking = effect(() => {
    lookedAt.value
    plot?.redraw(false)
  })
  const stopFitting = keepFitting(
    host,
    () => plot,
    () => cursor.refresh(),
  )
  return () => {
    clearTimeout(timer)
    stopRemaking()
    stopRefilling()
    stopMarking()
    stopFitting()
    plot?.destroy()
  }
}

function plotStyle(): PlotStyle {
  // The theme's colours are read from the page when the plot is made.
  theme.value
  return {
    colours: panels.value.map(({ slot }) => slotColour(slot)),
    showIterationBest: showIterationBest.value,
    showMean: showMean.value,
    levels: levels(),
    scale: metresPerCell.value ?? 1,
    axisLabels: {
      x: t('chart.iteration'),
      y: withUnit(t(showsCost() ? 'chart.cost' : 'chart.length')),
    },
    marker: () => lookedAt.peek(),
  }
}
