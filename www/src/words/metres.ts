/** Lengths in metres, on maps that have a scale. Fetched with the first of them, and with what tells more of lengths than the first sight. */
import { computed, effect, signal } from '@preact/signals'
import { language, numbers } from '../i18n'
import { addReadingWords, t } from '../i18n/reading'
import { decimalsFor } from '../model/metres'
import { scaleOf } from '../model/world'
import { scenario } from '../state'
import { lengthUnit } from '../state/length_unit'
import { heightWords } from './height_words'
import { metreWords } from './lengths'
import { placeWords } from './place_words'

const KILOMETRE = 1000

const isReady = signal(false)

/** Metres a cell of the map on show; null where it has no scale. */
export const scaleNow = computed(() => {
  const spec = scenario.value?.spec
  return spec && isReady.value ? scaleOf(spec) : null
})

/** The same while lengths are read in metres. By slices they are of cells and levels, which no metre is common to. */
export const metresPerCell = computed(() =>
  lengthUnit.value === 'cells' || scenario.value?.spec.terrain?.slices ? null : scaleNow.value,
)

/** What a scale bar counts: metres a cell, or cells; null on maps without a scale, whose cells are seen. */
export const barScale = computed(() =>
  scaleNow.value !== null && lengthUnit.value === 'cells' ? 1 : scaleNow.value,
)

/** How long a scale bar is, by what it counts. */
export const barWords = (length: number): string =>
  lengthUnit.value === 'cells' ? t('lengths.cells', { count: length }) : distanceWords(length)

/** Metres, as precise as a map of so many metres a cell is. */
export function metresFormat(resolution: number): Intl.NumberFormat {
  const digits = decimalsFor(resolution)
  const fixed = { minimumFractionDigits: digits, maximumFractionDigits: digits }
  return new Intl.NumberFormat(language.value, fixed)
}

const format = computed(() => metresFormat(metresPerCell.value ?? 1))

/** A length in cells as the number that stands under a head with its unit. */
export const lengthNumber = (cells: number): string =>
  metresPerCell.value === null
    ? numbers.value.length.format(cells)
    : format.value.format(cells * metresPerCell.value)

/** What a length is called, with its unit where that is not the cell. */
export const withUnit = (what: string): string =>
  metresPerCell.value === null ? what : t('lengths.inMetres', { what })

export const unitName = (): string =>
  t(metresPerCell.value === null ? 'lengths.unit.cells' : 'lengths.unit.metres')

/** Any number of metres, in kilometres from one on. */
export function distanceWords(metres: number): string {
  const far = metres >= KILOMETRE
  const write = new Intl.NumberFormat(language.value, { maximumSignificantDigits: 3 })
  const value = write.format(far ? metres / KILOMETRE : metres)
  return t(far ? 'lengths.kilometres' : 'lengths.metres', { value })
}

const ofLength = (cells: number) => t('lengths.metres', { value: lengthNumber(cells) })

/** Without their dictionary they are told in English; it is asked for again with the next words that come. */
addReadingWords()
  .catch(() => {})
  .then(() => {
    isReady.value = true
    effect(() => {
      const length = metresPerCell.value === null ? null : ofLength
      const place = scaleNow.value === null ? groundOfCell : placeOfCell
      metreWords.value = { length, place }
    })
  })

type Place = NonNullable<typeof metreWords.value>['place']

/** On a map without a scale. */
const groundOfCell: Place = (now, cell) => {
  const words = heightWords(now, cell)
  return words === null ? [] : [words]
}

const placeOfCell: Place = (now, cell) =>
  [heightWords(now, cell), placeWords(now, cell)].filter((said) => said !== null)
