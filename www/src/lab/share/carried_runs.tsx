/** All that a link carries of the recorded runs: how many of each entry on each map, and their digest. */
import type { Recorded } from '@pkg/formicarium'
import { t } from '../../i18n/lab'
import { shownComparison } from '../store/shown_comparison'

export function CarriedRuns({ recorded }: { recorded: Recorded }) {
  const now = shownComparison.value
  if (!now) return null
  const { instances, entries } = now.question
  const caption = t('lab.matrix.recorded.title')
  return (
    <section class="recorded-runs" aria-label={caption} data-testid="carried-runs">
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="result-scroll" tabIndex={0} aria-label={caption}>
        <table class="result-table">
          <caption class="visually-hidden">{caption}</caption>
          <thead>
            <tr>
              <th scope="col">{t('lab.matrix.recorded.entry')}</th>
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
                  <Carried key={map.id} runs={recorded.runs[at]?.[entry] ?? null} />
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </section>
      <p class="hint">{t('lab.matrix.recorded.notInIt')}</p>
    </section>
  )
}

function Carried({ runs }: { runs: Recorded['runs'][number][number] }) {
  if (!runs) return <td>{t('lab.matrix.recorded.none')}</td>
  return (
    <td>
      {t('lab.matrix.recorded.count', { count: runs.count })}
      <span class="cell-small digest">
        {t('lab.matrix.recorded.digest', { digest: runs.digest })}
      </span>
    </td>
  )
}
