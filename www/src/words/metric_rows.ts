/** The rows of the comparison table: where each number comes from and which way is better. */
import type { Family, RunSummary } from '@pkg/formicarium'
import { computed } from '@preact/signals'
import { language, numbers } from '../i18n'
import { gapShown } from './gap_words'
import { lengthNumber, metresPerCell } from './metres'

export type MetricId =
  | 'gap'
  | 'length'
  | 'unrefinedLength'
  | 'plannedLength'
  | 'plannedWeight'
  | 'walkedWeight'
  | 'turns'
  | 'turnIndex'
  | 'minClearance'
  | 'meanClearance'
  | 'travelTime'
  | 'turning'
  | 'largestCurvature'
  | 'smoothness'
  | 'energy'
  | 'lengthMetres'
  | 'climb'
  | 'descent'
  | 'steepest'
  | 'levelCost'
  | 'cost'
  | 'iterations'
  | 'iterationOfBest'
  | 'constructedPaths'
  | 'antMoves'
  | 'cellExpansions'

export interface MetricRow {
  id: MetricId
  better: 'lower' | 'higher' | null
  /** The only families that have it; the others show a dash. */
  families?: Family[]
  /** Left out while no panel has it. */
  optional?: true
  /** Of driving: shown where the scenario asks for it. */
  ofDriving?: true
  /** A length in cells, or one weighed, which is shown in metres on maps that have a scale. */
  isLength?: true
  value(summary: RunSummary, gap: number | null): number | null
  format(value: number): string
}

const decimal = (value: number) => numbers.value.length.format(value)
const whole = (value: number) => numbers.value.whole.format(value)
const digits = computed(
  () => new Intl.NumberFormat(language.value, { maximumSignificantDigits: 4 }),
)
/** What may be of any size, as it depends on how large cells are. */
export const significant = (value: number) => digits.value.format(value)

export const GAP_ROW: MetricRow = {
  id: 'gap',
  better: 'lower',
  value: (_, gap) => gap,
  format: gapShown,
}

/** Of a path: below the gap and what it is taken from, and the order of several goals. */
export const PATH_ROWS: MetricRow[] = [
  ofTour('plannedLength', (tour) => tour.planned_length),
  ofTour('plannedWeight', (tour) => tour.planned_weight),
  ofTour('walkedWeight', (tour) => tour.walked_weight),
  ofTerrain('levelCost', (terrain) => terrain.level_cost),
  { ...length('cost', 'lower', ofPath('cost')), optional: true },
  length('length', 'lower', ofPath('length')),
  {
    ...ofTerrain('lengthMetres', () => null),
    // Where all lengths are in metres the row above says it.
    value: ({ metrics }) =>
      metrics?.terrain && metresPerCell.value === null ? metrics.length_metres : null,
  },
  ofTerrain('climb', (terrain) => terrain.climb),
  ofTerrain('descent', (terrain) => terrain.descent),
  ofTerrain('steepest', (terrain) => terrain.steepest),
  {
    ...length('unrefinedLength', 'lower', (summary) => summary.unrefined_length),
    optional: true,
  },
  { id: 'turns', better: 'lower', value: ofPath('turns'), format: whole },
  length('turnIndex', 'lower', ofPath('turn_index')),
  length('minClearance', 'higher', ofPath('min_clearance')),
  length('meanClearance', 'higher', ofPath('mean_clearance')),
  { id: 'travelTime', better: 'lower', value: ofPath('travel_time'), format: decimal },
  ofDriving('turning', ({ turning }) => turning),
  ofDriving('largestCurvature', (driving) => driving.largest_curvature),
  ofDriving('smoothness', ({ smoothness }) => smoothness),
  ofDriving('energy', ({ energy }) => energy),
]

/** Of what it took to find it. */
export const EFFORT_ROWS: MetricRow[] = [
  iterative('iterations', ofEffort('iterations')),
  iterative('iterationOfBest', (summary) => summary.iteration_of_best),
  iterative('constructedPaths', ofEffort('constructed_paths')),
  iterative('antMoves', ofEffort('ant_moves')),
  {
    id: 'cellExpansions',
    better: null,
    // Of colonies only those have it that search as well.
    value: (summary) => summary.effort.cell_expansions || null,
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

function length(id: MetricId, better: MetricRow['better'], value: MetricRow['value']): MetricRow {
  return { id, better, value, format: lengthNumber, isLength: true }
}

function iterative(id: MetricId, value: MetricRow['value']): MetricRow {
  return { id, better: null, families: ['ant-colony', 'swarm', 'sampling'], value, format: whole }
}

type Tour = NonNullable<RunSummary['tour']>

function ofTour(id: MetricId, value: (tour: Tour) => number | null | undefined): MetricRow {
  const read = ({ tour }: RunSummary) => (tour ? value(tour) : null) ?? null
  return { ...length(id, 'lower', read), optional: true }
}

type Terrain = NonNullable<NonNullable<RunSummary['metrics']>['terrain']>

/** On a terrain alone. */
function ofTerrain(
  id: MetricId,
  value: (terrain: Terrain) => number | undefined | null,
): MetricRow {
  const read = ({ metrics }: RunSummary) =>
    (metrics?.terrain ? value(metrics.terrain) : null) ?? null
  return { id, better: 'lower', optional: true, value: read, format: decimal }
}

type Driving = NonNullable<NonNullable<RunSummary['metrics']>['driving']>

function ofDriving(id: MetricId, value: (driving: Driving) => number | undefined): MetricRow {
  const read = ({ metrics }: RunSummary) => (metrics?.driving && value(metrics.driving)) ?? null
  return { id, better: 'lower', optional: true, ofDriving: true, value: read, format: significant }
}

type PathMetric = Exclude<keyof NonNullable<RunSummary['metrics']>, 'terrain' | 'driving'>

function ofPath(key: PathMetric): MetricRow['value'] {
  return (summary) => summary.metrics?.[key] ?? null
}

function ofEffort(key: keyof RunSummary['effort']): MetricRow['value'] {
  return (summary) => summary.effort[key]
}
