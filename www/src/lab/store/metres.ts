/** Results in metres, where all maps of the comparison have a scale. The engine tells them in cells; files hold them as it does. */
import { computed } from '@preact/signals'
import type {
  Ablated,
  Analysis,
  BandPoint,
  Difference,
  EntryAnalysis,
  MapAnalysis,
  Measure,
  Summary,
  VerdictLine,
} from '../../model/analysis'
import type { MapOfQuestion } from '../../model/comparison'
import { scaleOf } from '../../model/world'
import { lengthUnit } from '../../state/length_unit'
import { openComparison } from './signals'

/** Of the measures those that are lengths, or lengths weighed. */
const OF_LENGTH: Measure[] = ['length', 'cost', 'turn-index', 'weight']

export const isOfLength = (measure: Measure) => OF_LENGTH.includes(measure)

/** none: no map has a scale · some: not all have one, or lengths are of cells and levels · all */
export type ScaledMaps = 'none' | 'some' | 'all'

export const scaledMaps = computed((): ScaledMaps => {
  const maps = openComparison.value?.maps ?? []
  const scaled = maps.map(scaleOfMap)
  if (scaled.length > 0 && scaled.every((scale) => scale !== null)) return 'all'
  return scaled.some((scale) => scale !== null) ? 'some' : 'none'
})

/** Metres a cell of each map, in their order; null where lengths are shown in cells. */
export const metresOfMaps = computed((): number[] | null =>
  scaledMaps.value === 'all' && lengthUnit.value === 'metres'
    ? (openComparison.value?.maps ?? []).map((map) => scaleOfMap(map) ?? 1)
    : null,
)

/** What a document leaves out has the engine's default. */
function scaleOfMap(map: MapOfQuestion): number | null {
  return map.terrain?.slices ? null : scaleOf({ ...map, resolution: map.resolution ?? 1 })
}

/** What the engine says of runs, in metres. */
export function inMetres(of: Analysis, metres: number[]): Analysis {
  const at = (index: number) => metres[index] ?? 1
  const places = new Map(of.instances.map(({ id }, index) => [id, index]))
  return {
    ...of,
    instances: of.instances.map((map, index) => ofMap(map, at(index))),
    matrix: {
      ...of.matrix,
      rows: of.matrix.rows.map((row, index) => ({
        ...row,
        cells: row.cells.map((cell) => ({
          ...cell,
          median: times(cell.median, factorOf(row.measure, at(index))),
        })),
      })),
    },
    verdicts: of.verdicts.map((line) => ofVerdict(line, at(places.get(line.instance) ?? 0))),
    ablation: of.ablation.map((one) => ofAblated(one, at(one.instance))),
  }
}

const factorOf = (measure: Measure, metres: number) => (isOfLength(measure) ? metres : 1)

function ofMap(map: MapAnalysis, metres: number): MapAnalysis {
  const [factor, ofCurve] = [map.measure, map.curve_measure].map((m) => factorOf(m, metres))
  return {
    ...map,
    targets: map.targets.map((target) => times(target, ofCurve)),
    references: map.references.map((one) => {
      const { reference, measure } = one
      if (!('value' in reference)) return one
      const value = times(reference.value, factorOf(measure, metres))
      return { ...one, reference: { ...reference, value } }
    }),
    entries: map.entries.map((entry) => ofEntry(entry, factor, ofCurve)),
  }
}

function ofEntry(entry: EntryAnalysis, factor = 1, ofCurve = 1): EntryAnalysis {
  const { values, summary, mean_interval, median_interval, best, band, published } = entry
  return {
    ...entry,
    values: values.map((value) => times(value, factor)),
    summary: summary && ofSummary(summary, factor),
    mean_interval: ofInterval(mean_interval, factor),
    median_interval: ofInterval(median_interval, factor),
    best: times(best, factor),
    band: band.map((point) => ofPoint(point, ofCurve)),
    published: published && {
      ...published,
      value: times(published.value, factor),
      optimum: times(published.optimum, factor),
    },
  }
}

function ofSummary({ count, ...all }: Summary, factor: number): Summary {
  const scaled = Object.entries(all).map(([key, value]) => [key, times(value, factor)])
  return { count, ...(Object.fromEntries(scaled) as Omit<Summary, 'count'>) }
}

const ofInterval = (ends: [number, number] | null, factor: number): [number, number] | null =>
  ends && [ends[0] * factor, ends[1] * factor]

const ofPoint = ({ x, lower, median, upper }: BandPoint, factor: number): BandPoint => ({
  x,
  lower: times(lower, factor),
  median: times(median, factor),
  upper: times(upper, factor),
})

function ofVerdict(line: VerdictLine, metres: number): VerdictLine {
  const factor = factorOf(line.measure, metres)
  return {
    ...line,
    baseline_value: times(line.baseline_value, factor),
    improved_value: times(line.improved_value, factor),
  }
}

function ofAblated(one: Ablated, metres: number): Ablated {
  const factor = factorOf(one.measure, metres)
  const effects = one.effects.map((effect) => ({
    ...effect,
    without: times(effect.without, factor),
    medians: ofDifference(effect.medians, factor),
    means: ofDifference(effect.means, factor),
  }))
  return { ...one, full: times(one.full, factor), effects }
}

const ofDifference = (of: Difference | null, factor: number): Difference | null =>
  of && { value: of.value * factor, low: of.low * factor, high: of.high * factor }

/** What is not known stays so. */
const times = <T extends number | null>(value: T, factor = 1) =>
  (value === null ? null : value * factor) as T
