/** All that a link carries of the recorded runs: what came out, where it tells that, how many there were, and their digest. */
import type { Recorded } from '@pkg/formicarium'
import { t } from '../../i18n/lab'
import type { Measure } from '../../model/analysis'
import type { RecordedNumbers } from '../../share/recorded_numbers'
import { gapShown } from '../../words/gap_words'
import { isOfLength, metresOfMaps } from '../store/metres'
import { shownAnalysis, shownComparison } from '../store/shown_comparison'
import { openComparison } from '../store/signals'
import { amount, dash } from '../words/numbers'

export function CarriedRuns({ recorded }: { recorded: Recorded }) {
  const now = shownComparison.value
  if (!now) return null
  const { instances, entries } = now.question
  const numbers = openComparison.value?.numbers ?? null
  const caption = t('lab.recorded.title')
  return (
    <section class="recorded-runs" aria-label={caption} data-testid="carried-runs">
      {numbers && (
        <p class="verification-head">
          <strong>{caption}</strong>
          <span class="chip verification-warn" data-testid="as-recorded">
            {t('lab.recorded.asRecorded')}
          </span>
        </p>
      )}
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="result-scroll" tabIndex={0} aria-label={caption}>
        <table class="result-table">
          <caption class="visually-hidden">{caption}</caption>
          <thead>
            <tr>
              <th scope="col">{t('lab.recorded.entry')}</th>
              {instances.map(({ id }, at) => (
                <th key={id} scope="col">
                  {now.maps[at]?.name || id}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {entries.map(({ id, label, results }, entry) => (
              <tr key={id}>
                <th scope="row">
                  {results ? t('lab.matrix.fromElsewhere', { name: label }) : label}
                </th>
                {instances.map((map, at) => (
                  <Carried
                    key={map.id}
                    runs={recorded.runs[at]?.[entry] ?? null}
                    numbers={numbers?.[at]?.[entry] ?? null}
                    measure={shownAnalysis.value?.instances[at]?.measure ?? 'length'}
                    metres={metresOfMaps.value?.[at] ?? 1}
                  />
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </section>
      <p class="hint">{t(numbers ? 'lab.recorded.notVerified' : 'lab.recorded.notInIt')}</p>
    </section>
  )
}

interface CarriedProps {
  runs: Recorded['runs'][number][number]
  numbers: RecordedNumbers | null
  measure: Measure
  /** Of a cell, where lengths are in metres; else 1. */
  metres: number
}

function Carried({ runs, numbers, measure, metres }: CarriedProps) {
  if (!runs && !numbers) return <td>{t('lab.recorded.none')}</td>
  return (
    <td>
      {numbers && <Numbers of={numbers} measure={measure} metres={metres} />}
      {!numbers && runs && t('lab.recorded.count', { count: runs.count })}
      {runs && (
        <span class="cell-small digest">{t('lab.recorded.digest', { digest: runs.digest })}</span>
      )}
    </td>
  )
}

interface NumbersProps {
  of: RecordedNumbers
  measure: Measure
  metres: number
}

function Numbers({ of, measure, metres }: NumbersProps) {
  const { runs, withPath, best, median, gap } = of
  const factor = isOfLength(measure) ? metres : 1
  const write = (value: number) => amount(measure)(factor * value)
  const paths = t('lab.recorded.paths', { part: withPath, whole: runs })
  if (median === null) return <>{`${t('lab.recorded.noPath')} · ${paths}`}</>
  return (
    <>
      {t('lab.recorded.median', { value: write(median) })}
      <span class="cell-small">
        {t('lab.recorded.best', { value: dash(best, write) })}
        {gap !== null && ` · ${t('lab.recorded.gap', { value: gapShown(gap) })}`}
      </span>
      <span class="cell-small">{paths}</span>
    </>
  )
}
