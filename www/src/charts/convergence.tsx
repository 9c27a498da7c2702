import { effect, signal, useComputed } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import type uPlot from 'uplot'
import { numbers, t } from '../i18n'
import {
  liveTick,
  lookedAt,
  notifyError,
  objectives,
  panels,
  references,
  slotColour,
  theme,
} from '../state'
import { referenceValue } from '../words/gap_words'
import { objectiveWord } from '../words/objective_words'
import { panelTitle } from '../words/planner_words'
import { curvesOf } from './convergence_data'
import type { PlotStyle } from './convergence_plot'
import { PanelKeys } from './panel_keys'

const showIterationBest = signal(true)
const showMean = signal(true)
/** Curves are redrawn no more often than a reader can follow. */
const REDRAW_MS = 160

export function Convergence() {
  return (
    <>
      <Legend />
      <Plot />
    </>
  )
}

function Toggles() {
  return (
    <>
      <Toggle label={t('chart.iterationBest')} kind="iteration-best" of={showIterationBest} />
      <Toggle label={t('chart.mean')} kind="mean" of={showMean} />
    </>
  )
}

function Toggle(props: { label: string; kind: string; of: typeof showMean }) {
  return (
    <li>
      <label class="toggle">
        <input
          type="checkbox"
          checked={props.of.value}
          onChange={(event) => {
            props.of.value = event.currentTarget.checked
          }}
        />
        <span class={`line-sample ${props.kind}`} aria-hidden="true" />
        {props.label}
      </label>
    </li>
  )
}

function Legend() {
  return (
    <ul class="legend">
      <PanelKeys />
      {levels().map(({ objective, length }) => (
        <li key={objective} data-testid="chart-optimum">
          <span class="line-sample optimum" aria-hidden="true" />
          {t(`chart.levels.${objectiveWord(objective)}`, {
            length: numbers.value.length.format(length),
          })}
        </li>
      ))}
      <Toggles />
    </ul>
  )
}

const LENGTHS = ['length', 'polyline-length', 'tour-length', 'slice-cost'] as const

/** The references that fit the curves, which show lengths, or costs by slices, whatever the objectives of the panels. */
function levels() {
  return LENGTHS.filter((id) => objectives.value.includes(id)).flatMap((objective) => {
    const length = referenceValue(references.value[objective] ?? null)
    return length === null ? [] : [{ objective, length }]
  })
}

/** By slices the curves may show costs instead of lengths. */
const showsCost = () =>
  objectives.value.includes('slice-cost') && objectiveWord('slice-cost') === 'slice-cost'

function Plot() {
  const host = useRef<HTMLDivElement>(null)
  const empty = useComputed(isEmpty)
  const words = useComputed(describe)
  useEffect(() => (host.current ? keepDrawn(host.current) : undefined), [])
  return (
    <div class="plot" data-empty={empty}>
      <div ref={host} class="plot-host" role="img" aria-label={words} data-testid="chart" />
      <p class="plot-hint">{t(showsCost() ? 'chart.emptyCost' : 'chart.empty')}</p>
    </div>
  )
}

function isEmpty(): boolean {
  return panels.value.every(({ live }) => !live.value.summary?.metrics)
}

/** The curve in words, for screen readers; the table beside it has the numbers. */
function describe(): string {
  const parts = panels.value.map(({ id, live }) => {
    const { metrics, value } = live.value.summary ?? {}
    const length = showsCost() ? value : metrics?.length
    return `${panelTitle(id)}: ${length == null ? '–' : numbers.value.length.format(length)}`
  })
  return `${t('chart.title')}. ${parts.join('; ')}`
}

/**
 * Makes the plot anew when its lines change, and refills it, at most every REDRAW_MS, when runs go on. The plotting library is
 * fetched when there is a first curve to draw: ants should not have to wait for it.
 */
function keepDrawn(host: HTMLElement): () => void {
  let library: typeof import('./convergence_plot') | null = null
  let plot: uPlot | null = null
  let style = plotStyle()
  let timer = 0
  const refill = () => {
    timer = 0
    if (library) plot?.setData(library.plotData(curvesOf(panels.peek()), style))
  }
  const remake = () => {
    plot?.destroy()
    plot = library?.makePlot(host, style) ?? null
    refill()
  }
  const stopFetching = effect(() => {
    if (library || isEmpty()) return
    import('./convergence_plot').then((fetched) => {
      library ??= fetched
      remake()
    }, notifyError)
  })
  const stopRemaking = effect(() => {
    style = plotStyle()
    remake()
  })
  const stopRefilling = effect(() => {
    liveTick.value
    if (timer === 0) timer = window.setTimeout(refill, REDRAW_MS)
  })
  const stopMarking = effect(() => {
    lookedAt.value
    plot?.redraw(false)
  })
  const resized = new ResizeObserver(() => {
    plot?.setSize({ width: Math.max(1, host.clientWidth), height: Math.max(1, host.clientHeight) })
  })
  resized.observe(host)
  return () => {
    clearTimeout(timer)
    stopFetching()
    stopRemaking()
    stopRefilling()
    stopMarking()
    resized.disconnect()
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
    levels: levels().map(({ length }) => length),
    axisLabels: { x: t('chart.iteration'), y: t(showsCost() ? 'chart.cost' : 'chart.length') },
    marker: () => lookedAt.peek(),
  }
}
