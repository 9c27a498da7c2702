/** The rows of the comparison table: where each number comes from and which way is better. */
import type { Family, RunSummary } from '@pkg/formicarium'
import { numbers } from '../i18n'

export type MetricId =
  | 'gap'
  | 'length'
  | 'turns'
  | 'turnIndex'
  | 'minClearance'
  | 'meanClearance'
  | 'travelTime'
  | 'iterations'
  | 'iterationOfBest'
  | 'constructedPaths'
  | 'antMoves'
  | 'cellExpansions'

export interface MetricRow {
  id: MetricId
  better: 'lower' | 'higher' | null
  /** The only family that has it; the others show a dash. */
  family?: Family
  value(summary: RunSummary, gap: number | null): number | null
  format(value: number): string
}

const decimal = (value: number) => numbers.value.length.format(value)
const whole = (value: number) => numbers.value.whole.format(value)
const percent = (value: number) => numbers.value.percent.format(value)

export const METRIC_ROWS: MetricRow[] = [
  { id: 'gap', better: 'lower', value: (_, gap) => gap, format: percent },
  { id: 'length', better: 'lower', value: ofPath('length'), format: decimal },
  { id: 'turns', better: 'lower', value: ofPath('turns'), format: whole },
  { id: 'turnIndex', better: 'lower', value: ofPath('turn_index'), format: decimal },
  { id: 'minClearance', better: 'higher', value: ofPath('min_clearance'), format: decimal },
  { id: 'meanClearance', better: 'higher', value: ofPath('mean_clearance'), format: decimal },
  { id: 'travelTime', better: 'lower', value: ofPath('travel_time'), format: decimal },
  colony('iterations', ofEffort('iterations')),
  colony('iterationOfBest', (summary) => summary.iteration_of_best),
  colony('constructedPaths', ofEffort('constructed_paths')),
  colony('antMoves', ofEffort('ant_moves')),
  {
    id: 'cellExpansions',
    better: null,
    family: 'exact',
    value: ofEffort('cell_expansions'),
    format: whole,
  },
]

/** Indices of the best values of a row; none when they all agree or the row does not rank. */
export function bestOf(values: (number | null)[], better: MetricRow['better']): Set<number> {
  const known = values.filter((value) => value !== null)
  const best = better === 'lower' ? Math.min(...known) : Math.max(...known)
  if (better === null || known.length < 2 || known.every((value) => value === best)) {
    return new Set()
  }
  return new Set(values.flatMap((value, index) => (value === best ? [index] : [])))
}

function colony(id: MetricId, value: MetricRow['value']): MetricRow {
  return { id, better: null, family: 'ant-colony', value, format: whole }
}

function ofPath(key: keyof NonNullable<RunSummary['metrics']>): MetricRow['value'] {
  return (summary) => summary.metrics?.[key] ?? null
}

function ofEffort(key: keyof RunSummary['effort']): MetricRow['value'] {
  return (summary) => summary.effort[key]
}
