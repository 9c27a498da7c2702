/** The histories of all panels on one axis of iterations, thinned to what a screen can show. */
import { historyOf, type Panel, plannerEntry } from '../state'
import type { HistoryRows } from '../state/history_rows'

/** Columns of a history row (see messages.ts). */
const ITERATION = 0
const BEST_SO_FAR = 1
const ITERATION_BEST = 2
const MEAN = 3
const MOST_POINTS = 1200
/** The axis begins with this many, so that the first points do not fill the whole width. */
const FEWEST_ITERATIONS = 10

export type Curve = (number | null)[]

export interface PanelCurves {
  best: Curve
  iterationBest: Curve
  mean: Curve
}

export interface Curves {
  iterations: number[]
  panels: PanelCurves[]
}

export function curvesOf(panels: Panel[]): Curves {
  const known = Math.max(0, ...panels.map(({ id }) => lastIteration(historyOf(id))))
  const last = known === 0 ? 0 : Math.max(known, FEWEST_ITERATIONS)
  const stride = Math.max(1, Math.ceil(last / MOST_POINTS))
  const points = Math.ceil(last / stride)
  const iterations = Array.from({ length: points }, (_, i) => Math.min(last, (i + 1) * stride))
  return { iterations, panels: panels.map((panel) => curves(panel, points, stride)) }
}

function curves(panel: Panel, points: number, stride: number): PanelCurves {
  const rows = historyOf(panel.id)
  const best = column(rows, BEST_SO_FAR, points, stride)
  if (hasEnded(panel)) prolong(best)
  if (isExact(panel)) {
    const none: Curve = best.map(() => null)
    return { best: best.fill(best.at(-1) ?? null), iterationBest: none, mean: none }
  }
  return {
    best,
    iterationBest: column(rows, ITERATION_BEST, points, stride),
    mean: column(rows, MEAN, points, stride),
  }
}

/** The last row of every stride; iterations without an arrived ant leave a hole. */
function column(rows: HistoryRows, index: number, points: number, stride: number): Curve {
  const curve: Curve = Array.from({ length: points }, () => null)
  for (let row = 0; row < rows.count; row++) {
    const point = Math.ceil(rows.at(row, ITERATION) / stride) - 1
    const value = rows.at(row, index)
    if (point >= 0 && point < points && Number.isFinite(value)) curve[point] = value
  }
  return curve
}

/** What a finished run has found stays found while the others go on. */
function prolong(curve: Curve): void {
  let last: number | null = null
  for (let i = 0; i < curve.length; i++) {
    if (curve[i] === null) curve[i] = last
    else last = curve[i] ?? null
  }
}

/** An exact planner has no iterations: its length is drawn as one level across. */
function isExact({ setup }: Panel): boolean {
  return plannerEntry(setup.planner)?.family === 'exact'
}

function hasEnded(panel: Panel): boolean {
  const status = panel.live.peek().summary?.status
  return status !== undefined && status !== 'running'
}

function lastIteration(rows: HistoryRows): number {
  return rows.count === 0 ? 0 : rows.at(rows.count - 1, ITERATION)
}
