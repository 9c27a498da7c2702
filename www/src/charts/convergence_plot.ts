/** uPlot, set up for convergence curves in the page's colours. */
import 'uplot/dist/uPlot.min.css'
import uPlot from 'uplot'
import type { ChartCursor } from './chart_cursor'
import { chartLook } from './chart_style'
import type { Curve, Curves } from './convergence_data'

const WHOLE_STEPS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000]

export interface PlotStyle {
  colours: string[]
  showIterationBest: boolean
  showMean: boolean
  /** What values are multiplied by: metres a cell, or 1. */
  scale: number
  /** References, drawn as lines from an iteration on. */
  levels: { length: number; from: number }[]
  axisLabels: { x: string; y: string }
  /** The iteration being looked back at, read at every drawing; null for none. */
  marker: () => number | null
}

export function makePlot(host: HTMLElement, style: PlotStyle, cursor: ChartCursor): uPlot {
  return new uPlot(options(host, style, cursor), [[]], host)
}

export function plotData(curves: Curves, { levels: of, scale }: PlotStyle): uPlot.AlignedData {
  const levels = of.map(({ length, from }) =>
    curves.iterations.map((iteration) => (iteration < from ? null : length * scale)),
  )
  const scaled = (curve: Curve) => curve.map((value) => value && value * scale)
  const panels = curves.panels.flatMap(({ best, iterationBest, mean }) =>
    [mean, iterationBest, best].map(scaled),
  )
  return [curves.iterations, ...levels, ...panels]
}

function options(host: HTMLElement, style: PlotStyle, cursor: ChartCursor): uPlot.Options {
  const { colour, axis, frame } = chartLook(host)
  return {
    ...frame,
    padding: [10, 12, 0, 0],
    plugins: [cursor.plugin],
    scales: { x: { time: false, range: cursor.range }, y: { range: yRange(style.scale) } },
    axes: [
      { ...axis, label: style.axisLabels.x, size: 22, incrs: WHOLE_STEPS },
      { ...axis, label: style.axisLabels.y, size: 40 },
    ],
    hooks: { draw: [(plot) => drawMarker(plot, style.marker(), colour('--info'))] },
    series: [
      {},
      ...style.levels.map(() => levelSeries(colour('--text'))),
      ...style.colours.flatMap(panelSeries(style)),
    ],
  }
}

/** A line across all lengths. */
function drawMarker(plot: uPlot, iteration: number | null, colour: string): void {
  if (iteration === null) return
  const { ctx, bbox } = plot
  const x = Math.round(Math.max(bbox.left, plot.valToPos(iteration, 'x', true)))
  ctx.save()
  ctx.strokeStyle = colour
  ctx.lineWidth = 2 * devicePixelRatio
  ctx.beginPath()
  ctx.moveTo(x, bbox.top)
  ctx.lineTo(x, bbox.top + bbox.height)
  ctx.stroke()
  ctx.restore()
}

function levelSeries(stroke: string): uPlot.Series {
  return { stroke, width: 1.5, dash: [2, 4], points: { show: false } }
}

function panelSeries({ showIterationBest, showMean }: PlotStyle) {
  return (stroke: string): uPlot.Series[] => {
    const points = { show: isLone, size: 7, stroke, fill: stroke }
    const faint = { stroke: `${stroke}99`, width: 1, points, spanGaps: true }
    const stepped = uPlot.paths.stepped?.({ align: 1 })
    return [
      { ...faint, dash: [4, 3], show: showMean },
      { ...faint, show: showIterationBest },
      { stroke, width: 2.5, paths: stepped, points, spanGaps: true },
    ]
  }
}

/** One value makes no line: it is shown as a point. */
const isLone: uPlot.Series.Points.Show = (plot, series) => {
  let values = 0
  for (const value of plot.data[series] ?? []) {
    if (value != null && ++values > 1) return false
  }
  return values === 1
}

/** Room above and below, so that the lines to compare with never lie on the frame. */
const yRange =
  (scale: number): uPlot.Range.Function =>
  (_, min, max) => {
    if (min == null || max == null) return [0, scale]
    const room = Math.max((max - min) * 0.08, max * 0.01, 0.5 * scale)
    return [min - room, max + room]
  }
