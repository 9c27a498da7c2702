/** Maps × planners: what came out of each in one field, shaded by its gap. */
import '../../styles/lab_matrix.css'
import { signal } from '@preact/signals'
import { t } from '../../i18n/lab'
import type { Analysis, MapAnalysis, Matrix, MatrixRow } from '../../model/analysis'
import { Labelled, Segmented } from '../../ui/fields'
import { labelOf, measureWords, share } from '../words/numbers'
import { chooseMap, dotColour } from './choices'
import { heatOf, MatrixField, OverallField, SHOWS, type Shows, thresholds } from './matrix_fields'

const large = signal<Shows>('median')

interface TabProps {
  analysis: Analysis
  /** Shows all numbers of the chosen map. */
  onMap: () => void
}

export function MatrixTab({ analysis, onMap }: TabProps) {
  const { matrix } = analysis
  return (
    <>
      <div class="result-choices">
        <Labelled label={t('lab.matrix.large')}>
          <Segmented
            label={t('lab.matrix.large')}
            value={large.value}
            options={SHOWS.map((value) => ({
              value,
              label: t(`lab.matrix.shows.${value}`),
              testId: `matrix-${value}`,
            }))}
            onChange={(value) => {
              large.value = value
            }}
          />
        </Labelled>
        <Legend analysis={analysis} />
      </div>
      <Table analysis={analysis} matrix={matrix} onMap={onMap} />
      <Notes analysis={analysis} />
    </>
  )
}

/** What the shades stand for; the gap stands in every field as well. */
function Legend({ analysis }: { analysis: Analysis }) {
  const gaps = thresholds(analysis)
  if (gaps.length === 0) return null
  const most = gaps.at(-1) ?? 0
  return (
    <ul class="matrix-legend" aria-label={t('lab.matrix.legend')}>
      <li class="hint" aria-hidden="true">
        {t('lab.matrix.legend')}
      </li>
      {gaps.map((gap, level) => (
        <li key={gap}>
          <span class="matrix-shade" style={{ '--heat': level }} aria-hidden="true" />
          {t('lab.matrix.atMost', { gap: share(gap) })}
        </li>
      ))}
      <li>
        <span class="matrix-shade" style={{ '--heat': gaps.length }} aria-hidden="true" />
        {t('lab.matrix.above', { gap: share(most) })}
      </li>
    </ul>
  )
}

interface TableProps extends TabProps {
  matrix: Matrix
}

function Table({ analysis, matrix, onMap }: TableProps) {
  const entries = analysis.instances[0]?.entries ?? []
  const caption = t('lab.matrix.caption')
  const wrong = matrix.overall.map(({ unranked }) => unranked === 'impossible')
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="result-scroll" tabIndex={0} aria-label={caption}>
      <table class="result-table matrix-table" data-testid="matrix-table">
        <caption class="visually-hidden">{caption}</caption>
        <thead>
          <tr>
            <th scope="col">{t('lab.matrix.map')}</th>
            {entries.map((entry, index) => (
              <th
                key={entry.id}
                scope="col"
                style={{ '--panel-colour': dotColour(entry, index) }}
                data-testid={`matrix-head-${entry.id}`}
              >
                <span class="panel-dot" aria-hidden="true" />
                {labelOf({ ...entry, impossible: wrong[index] ? 1 : 0 })}
                <Objective analysis={analysis} index={index} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {matrix.rows.map((row, at) => {
            const map = analysis.instances[at]
            return map && <Row key={row.id} row={row} map={map} onMap={onMap} />
          })}
          {matrix.rows.length > 1 && (
            <tr class="matrix-overall" data-testid="matrix-overall">
              <th scope="row">
                {t('lab.matrix.allMaps')}
                <span class="cell-small">{t('lab.matrix.allMapsNote')}</span>
              </th>
              {matrix.overall.map((all, at) => (
                <OverallField key={entries[at]?.id} all={all} of={matrix} large={large.value} />
              ))}
            </tr>
          )}
        </tbody>
      </table>
    </section>
  )
}

/** What an entry makes small, where entries differ in that. */
function Objective({ analysis, index }: { analysis: Analysis; index: number }) {
  const mixed = analysis.instances.find(({ mixed_objectives }) => mixed_objectives)
  const objective = mixed?.entries[index]?.objective
  if (!objective) return null
  return (
    <span class="cell-small">
      {t('lab.matrix.makesSmall', { objective: t(`objective.${objective}`) })}
    </span>
  )
}

function Row({ row, map, onMap }: { row: MatrixRow; map: MapAnalysis; onMap: () => void }) {
  const name = map.name || map.id
  const ranks = row.cells.flatMap(({ rank }) => rank ?? [])
  const best = ranks.length > 1 ? Math.min(...ranks) : null
  return (
    <tr data-testid={`matrix-${row.id}`}>
      <th scope="row">
        <button
          type="button"
          class="matrix-map"
          title={t('lab.matrix.details', { map: name })}
          data-testid={`matrix-map-${row.id}`}
          onClick={() => {
            chooseMap(row.id)
            onMap()
          }}
        >
          {name}
        </button>
        <span class="cell-small">{measureWords(row.measure)}</span>
      </th>
      {row.cells.map((cell, at) => (
        <MatrixField
          key={map.entries[at]?.id}
          cell={cell}
          measure={row.measure}
          large={large.value}
          heat={heatOf(cell, map)}
          isBest={best !== null && cell.rank === best}
        />
      ))}
    </tr>
  )
}

function Notes({ analysis: { matrix } }: { analysis: Analysis }) {
  const reasons = new Set(matrix.overall.flatMap(({ unranked }) => unranked ?? []))
  return (
    <ul class="footnotes" data-testid="matrix-notes">
      <li>{t('lab.matrix.how')}</li>
      {reasons.has('impossible') && <li>{t('lab.matrix.markNote')}</li>}
    </ul>
  )
}
