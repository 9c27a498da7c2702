/** The histories of all panels on one axis of iterations, thinned to what a screen can show. */

import { historyOf, type Panel } from '../state'
import { BEST_SO_FAR, type HistoryRows } from '../state/history_rows'
import { isSearch } from '../words/planner_words'

/** Columns of a history row (see messages.ts). */
const ITERATION = 0
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
  const known = Math.max(0, ...panels.map(lastIteration))
  const last = known === 0 ? 0 : Math.max(known, FEWEST_ITERATIONS)
  const stride = Math.max(1, Math.ceil(last / MOST_POINTS))
  const points = Math.ceil(last / stride)
  const iterations = Array.from({ length: points }, (_, i) => Math.min(last, (i + 1) * stride))
  return { iterations, panels: panels.map((panel) => curves(panel, points, stride)) }
}

function curves(panel: Panel, points: number, stride: number): PanelCurves {
  const rows = historyOf(panel.id)
  // A search has no iterations: its length is drawn as one level across.
  if (isSearch(panel.setup.planner)) {
    const none: Curve = Array.from({ length: points }, () => null)
    const length = rows.count > 0 ? rows.at(rows.count - 1, BEST_SO_FAR) : Number.NaN
    const best = none.map(() => (Number.isFinite(length) ? length : null))
    return { best, iterationBest: none, mean: none }
  }
  const best = column(rows, BEST_SO_FAR, points, stride)
  if (hasEnded(panel)) prolong(best)
  return {
    best,
    iterationBest: column(rows, ITERATION_BEST, points, stride),
    mean: column(rows, MEAN, points, stride),
  }
}

/** What a panel had reached by an iteration; null where it had nothing, or has no iterations. */
export interface Reached {
  best: number | null
  iterationBest: number | null
  mean: number | null
}

export function reachedAt(panel: Panel, iteration: number): Reached {
  const rows = historyOf(panel.id)
  const search = isSearch(panel.setup.planner)
  const row = search ? rows.count - 1 : lastRowUpTo(rows, iteration)
  const at = (column: number) => finite(row < 0 ? Number.NaN : rows.at(row, column))
  const own = !search && row >= 0 && rows.at(row, ITERATION) === iteration
  return {
    best: at(BEST_SO_FAR),
    iterationBest: own ? at(ITERATION_BEST) : null,
    mean: own ? at(MEAN) : null,
  }
}

const finite = (value: number) => (Number.isFinite(value) ? value : null)

/** Rows are in the order of their iterations. -1 where all are later. */
function lastRowUpTo(rows: HistoryRows, iteration: number): number {
  let [low, high] = [-1, rows.count - 1]
  while (low < high) {
    const middle = (low + high + 1) >> 1
    if (rows.at(middle, ITERATION) <= iteration) low = middle
    else high = middle - 1
  }
  return low
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

function hasEnded(panel: Panel): boolean {
  const status = panel.live.peek().summary?.status
  return status !== undefined && status !== 'running'
}

/** A search has no iterations: its count only says that there is something to show. */
function lastIteration({ id, setup }: Panel): number {
  const rows = historyOf(id)
  if (rows.count === 0) return 0
  return isSearch(setup.planner) ? 1 : rows.at(rows.count - 1, ITERATION)
}
