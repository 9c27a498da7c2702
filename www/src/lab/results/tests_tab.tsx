/** Whether entries differ: rank tests of all pairs of a map, and of ranks over all maps, in numbers and in words. */
import { signal } from '@preact/signals'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Analysis, MapAnalysis, Ranks } from '../../model/analysis'
import { Segmented } from '../../ui/fields'
import { DataTable } from '../figures/data_table'
import { LEVEL } from '../figures/rank_groups'
import { ranked } from '../figures/ranks'
import { chance, labelOf, significant } from '../words/numbers'
import { MapChoice, MapHead, shownMap } from './choices'
import { differ, type Kind, type PairTest, pairTest, shownEffect } from './pair_tests'
import { sentences } from './tests_words'

/** From this many maps on, the approximation of Friedman's test is good (Demšar 2006). */
const MANY_MAPS = 10

const kind = signal<Kind>('wilcoxon')

export function TestsTab({ analysis }: { analysis: Analysis }) {
  const map = shownMap(analysis)
  if (!map) return null
  return (
    <>
      <div class="result-choices">
        <MapChoice analysis={analysis} />
        <Segmented
          label={t('lab.results.test')}
          value={kind.value}
          options={(['wilcoxon', 'mann-whitney'] as const).map((value) => ({
            value,
            label: t(`lab.results.tests.${value}`),
            testId: `test-${value}`,
          }))}
          onChange={(value) => {
            kind.value = value
          }}
        />
      </div>
      <MapHead map={map} />
      <Sentences map={map} />
      <Matrix map={map} />
      <p class="hint">
        {t('lab.results.matrixHint', { level: numbers.value.share.format(LEVEL) })}
      </p>
      <Overall analysis={analysis} />
    </>
  )
}

function Sentences({ map }: { map: MapAnalysis }) {
  return (
    <ul class="result-sentences" data-testid="test-sentences">
      {sentences(map, kind.value).map((words) => (
        <li key={words}>{words}</li>
      ))}
    </ul>
  )
}

/** How likely a run of the row's entry beats one of the column's. */
function Matrix({ map }: { map: MapAnalysis }) {
  const shown = map.entries.flatMap((entry, index) => (entry.runs > 0 ? [{ entry, index }] : []))
  if (shown.length < 2) return null
  const caption = t('lab.results.matrix')
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="result-scroll" tabIndex={0} aria-label={caption}>
      <table class="result-table test-matrix" data-testid="test-matrix">
        <caption class="visually-hidden">{caption}</caption>
        <thead>
          <tr>
            <td>{t('lab.results.beats')}</td>
            {shown.map(({ entry }) => (
              <th key={entry.id} scope="col">
                {labelOf(entry)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {shown.map((row) => (
            <tr key={row.entry.id}>
              <th scope="row">{labelOf(row.entry)}</th>
              {shown.map((column) => (
                <MatrixCell
                  key={column.entry.id}
                  pair={pairTest(map, row.index, column.index, kind.value)}
                />
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  )
}

function MatrixCell({ pair }: { pair: PairTest | null }) {
  if (!pair) return <td class="diagonal">–</td>
  const { better, p } = pair
  const leaning = differ(pair) && better !== 0.5 ? (better > 0.5 ? 'ahead' : 'behind') : 'even'
  return (
    <td
      class={`leaning-${leaning}`}
      style={{ '--size': Math.min(1, 2 * Math.abs(better - 0.5)).toFixed(2) }}
    >
      <span class="matrix-main">{numbers.value.length.format(better)}</span>
      <span class="cell-small">{t(`lab.results.effects.${shownEffect(pair)}`)}</span>
      <span class="cell-small">
        {p === null ? t('lab.results.untested') : `p ${p < 0.001 ? '' : '= '}${chance(p)}`}
      </span>
    </td>
  )
}

function Overall({ analysis }: { analysis: Analysis }) {
  const { ranks, instances } = analysis
  return (
    <section class="result-overall" aria-label={t('lab.results.overall')}>
      <h3>{t('lab.results.overall')}</h3>
      {ranks ? (
        <RankTests analysis={analysis} ranks={ranks} />
      ) : (
        <p class="hint">{t(instances.length < 2 ? 'lab.results.oneMap' : 'lab.results.noRanks')}</p>
      )}
    </section>
  )
}

function RankTests({ analysis, ranks }: { analysis: Analysis; ranks: Ranks }) {
  const { statistic, degrees, p, maps, pairs } = ranks
  const order = ranked(analysis, ranks)
  const label = (entry: number) => order.find((each) => each.entry === entry)?.label ?? ''
  const best = order[0]
  const words = { statistic: significant(statistic), degrees, p: chance(p), maps }
  const differs = p < LEVEL
  return (
    <>
      <p>{t('lab.results.friedman', words)}</p>
      <p>
        {t(differs ? 'lab.results.ranksDiffer' : 'lab.results.ranksAlike', {
          best: best?.label ?? '',
        })}{' '}
        {maps < MANY_MAPS && t('lab.results.fewMaps')}
      </p>
      <DataTable
        caption={t('lab.results.postHoc')}
        columns={(['pair', 'ranks', 'chance', 'holm'] as const).map((key) =>
          t(`lab.results.columns.${key}`),
        )}
        rows={[...pairs]
          .sort((a, b) => a.holm - b.holm)
          .map(({ first, second, p: each, holm }) => [
            `${label(first)} – ${label(second)}`,
            [first, second]
              .map((entry) => significant(order.find((one) => one.entry === entry)?.mean ?? 0))
              .join(' – '),
            chance(each),
            chance(holm),
          ])}
      />
    </>
  )
}
