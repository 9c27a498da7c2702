/** Numbers and names of results in the reader's language. */
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Axis, EntryAnalysis, MapAnalysis, Measure } from '../../model/analysis'
import { metresFormat } from '../../words/metres'
import { isOfLength, metresOfMaps } from '../store/metres'

type Write = (value: number) => string

/** Counts are whole, and lengths are not. */
const COUNTED: Measure[] = [
  'turns',
  'iteration-of-best',
  'paths-to-best',
  'ant-moves',
  'running-time',
]

/** How a measure is written. */
export function amount(measure: Measure): Write {
  if (COUNTED.includes(measure)) return count
  const metres = isOfLength(measure) ? metresOfMaps.value : null
  const format = metres ? metresFormat(Math.min(...metres)) : numbers.value.length
  return format.format
}

/** Medians of counts may lie halfway between two. */
export const count: Write = (value) =>
  Number.isInteger(value) ? numbers.value.whole.format(value) : numbers.value.metres.format(value)

/** Efforts reach millions and are never exact to the last digit; times have three digits at most. */
export function effort(axis: Axis): Write {
  if (axis === 'time') return (value) => `${significant(value)} ${t('lab.results.secondsShort')}`
  return (value) => (Math.abs(value) < 10_000 ? count(Math.round(value * 10) / 10) : compact(value))
}

const localeOf = () => numbers.value.whole.resolvedOptions().locale

/** 1,500,000 as 1.5M. */
export const compact: Write = (value) =>
  new Intl.NumberFormat(localeOf(), { notation: 'compact', maximumSignificantDigits: 3 }).format(
    value,
  )

export const significant: Write = (value) =>
  new Intl.NumberFormat(localeOf(), { maximumSignificantDigits: 3 }).format(value)

/** Published numbers, with the digits that were printed. */
export const precise: Write = (value) =>
  new Intl.NumberFormat(localeOf(), { maximumFractionDigits: 6 }).format(value)

/** A p-value: never 0, for chance is never ruled out. */
export function chance(p: number): string {
  const digits = { minimumFractionDigits: 3, maximumFractionDigits: 3 }
  const format = new Intl.NumberFormat(localeOf(), digits)
  return p < 0.001 ? `< ${format.format(0.001)}` : format.format(p)
}

export const share: Write = (value) =>
  new Intl.NumberFormat(localeOf(), { style: 'percent', maximumFractionDigits: 1 }).format(value)

/** "28.14 to 30.02" as it stands in tables. */
export const range = (low: number, high: number, write: Write) => `${write(low)} – ${write(high)}`

/** A dash where there is no number. What is infinite has none: no path. */
export const dash = (value: number | null | undefined, write: Write) =>
  value == null || !Number.isFinite(value) ? '–' : write(value)

export function measureWords(measure: Measure): string {
  const inMetres = metresOfMaps.value !== null && isOfLength(measure)
  return t(
    inMetres
      ? `lab.results.measuresInMetres.${measure as 'length'}`
      : `lab.results.measures.${measure}`,
  )
}

/** With what is counted, as it stands at axes. */
export const axisWords = (axis: Axis) => t(`lab.results.axes.${axis}`)

/** The best there is by what a measure is about: of paths by steps, of polylines… Only what is proven. */
export interface ExactOptimum {
  value: number
  /** What it is called beside its value. */
  words: string
}

export function optimaOf(
  { references, measure }: Pick<MapAnalysis, 'references' | 'measure'>,
  of = measure,
): ExactOptimum[] {
  const about = references.filter((yardstick) => yardstick.measure === of)
  const proven = about.flatMap(({ objective, reference }) =>
    reference.kind === 'proven' ? [{ objective, value: reference.value }] : [],
  )
  return proven.map(({ objective, value }) => {
    const shown = amount(of)(value)
    const words =
      proven.length === 1
        ? t('lab.results.optimumIs', { value: shown })
        : `${t(`objective.${objective}`)} ${shown}`
    return { value, words }
  })
}

type Named = Pick<EntryAnalysis, 'label' | 'origin' | 'impossible'>

/** That results are from elsewhere, and that some of them cannot be, stays with the name wherever it stands. */
export function labelOf({ label, origin, impossible }: Named): string {
  const name = origin === 'results' ? t('lab.matrix.fromElsewhere', { name: label }) : label
  return impossible > 0 ? t('lab.matrix.marked', { name }) : name
}
