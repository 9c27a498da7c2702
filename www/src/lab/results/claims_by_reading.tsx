/** Claims by the reading of the paper that they are about: which readings are shown, and all of them side by side. */
import { signal } from '@preact/signals'
import '../../styles/radio_segments.css'
import { t } from '../../i18n/lab'
import { t as tOfReadings } from '../../i18n/readings'
import type { Analysis, OverMaps, PaperReading } from '../../model/analysis'
import { Labelled } from '../../ui/fields'
import { RadioSegments } from '../../ui/radio_segments'
import { measureWords } from '../words/numbers'
import { Chip, change, partOfMaps, within } from './claim_cells'

type Shown = PaperReading | 'all'

/** Kept while the page is open, for every question that has claims about the reading. */
const chosen = signal<Shown>('all')

/** All where no claim is about the chosen one. */
const shown = ({ by_reading }: Analysis): Shown =>
  by_reading.readings.find((reading) => reading === chosen.value) ?? 'all'

/** Whether a claim is in the table. */
export const isOfShownReading = (analysis: Analysis) => {
  const now = shown(analysis)
  return ({ reading }: OverMaps) => now === 'all' || reading === now
}

/** Nothing where no claim names a reading. */
export function ReadingChoice({ analysis }: { analysis: Analysis }) {
  const { readings } = analysis.by_reading
  if (readings.length === 0) return null
  const options: Shown[] = ['all', ...readings]
  return (
    <div class="result-choices">
      <Labelled label={tOfReadings('readings.title')}>
        <RadioSegments
          label={tOfReadings('readings.title')}
          value={shown(analysis)}
          options={options.map((value) => ({ value, label: nameOf(value) }))}
          testId="claims-reading"
          onChange={(value) => {
            chosen.value = value
          }}
        />
      </Labelled>
    </div>
  )
}

const nameOf = (reading: Shown) =>
  tOfReadings(reading === 'all' ? 'readings.all' : `readings.names.${reading}`)

/** What is said of a claim, with its reading where it names one. */
export const withReading = ({ reading }: OverMaps, claim: string) =>
  reading ? tOfReadings('readings.ofClaim', { claim, reading: nameOf(reading) }) : claim

/** The table reading × claim, while all are shown. */
export function ClaimsByReading({ analysis }: { analysis: Analysis }) {
  const { readings, rows } = analysis.by_reading
  if (readings.length === 0 || shown(analysis) !== 'all') return null
  const caption = tOfReadings('readings.claims')
  return (
    <section class="reported-map">
      <h3>{caption}</h3>
      <p class="hint">{tOfReadings('readings.claimsHint')}</p>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="result-scroll" tabIndex={0} aria-label={caption}>
        <table class="result-table verdicts" data-testid="claims-by-reading">
          <caption class="visually-hidden">{caption}</caption>
          <thead>
            <tr>
              <th scope="col">{t('lab.claims.columns.claim')}</th>
              {readings.map((reading) => (
                <th key={reading} scope="col">
                  {nameOf(reading)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map(({ claims }) => (
              <Row key={claims.join()} claims={claims} analysis={analysis} />
            ))}
          </tbody>
        </table>
      </section>
    </section>
  )
}

/** By reading the place of its claim among those over maps. */
function Row({ claims, analysis }: { claims: (number | null)[]; analysis: Analysis }) {
  const found = claims.map((place) => (place === null ? undefined : analysis.over_maps[place]))
  const first = found.find((over) => over !== undefined)
  if (!first) return null
  return (
    <tr>
      <th scope="row">
        {first.says}
        <span class="cell-small">{measureWords(first.measure)}</span>
      </th>
      {found.map((over, column) => (
        <td key={analysis.by_reading.readings[column]}>{over ? <Outcome over={over} /> : '–'}</td>
      ))}
    </tr>
  )
}

function Outcome({ over }: { over: OverMaps }) {
  return (
    <>
      <Chip verdict={over.verdict} />
      <span class="cell-small">{partOfMaps(over)}</span>
      {over.median !== null && (
        <span class="cell-small">
          {change(over, over.median)}
          {over.confidence !== null && ` (${within(over, over.low, over.high)})`}
        </span>
      )}
    </>
  )
}
