/** The numbers of one map: a row an entry, sorted by any column, the best of each column set off. */
import { signal } from '@preact/signals'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { listed } from '../../i18n/lists'
import type { Analysis, EntryAnalysis, MapAnalysis } from '../../model/analysis'
import { Select } from '../../ui/fields'
import { bestOf } from '../../words/metric_rows'
import { shownComparison } from '../store/shown_comparison'
import { amount, dash, labelOf, measureWords, optimaOf } from '../words/numbers'
import { Alert, AxisChoice, dotColour, MapChoice, MapHead, shownMap } from './choices'
import { type Column, type ColumnId, columnsOf, headOf, type Table } from './summary_columns'

/** As the question has it, until a column is chosen. */
const sorting = signal<{ column: ColumnId; descending: boolean } | null>(null)
const chosenTarget = signal<number | null>(null)

export function SummaryTab({ analysis }: { analysis: Analysis }) {
  const map = shownMap(analysis)
  if (!map) return null
  // Within one per cent: strict, yet met often enough to say something.
  const usual = map.target_gaps.findIndex((gap) => gap <= 0.01)
  const target = Math.min(
    chosenTarget.value ?? Math.max(0, usual),
    Math.max(0, map.targets.length - 1),
  )
  const table = { analysis, map, target }
  return (
    <>
      <div class="result-choices">
        <MapChoice analysis={analysis} />
        <AxisChoice />
        {map.targets.length > 0 && <TargetChoice map={map} target={target} />}
        {map.targets.length > 0 && (
          <span class="hint">
            {t('lab.results.targetIs', {
              value: dash(map.targets[target], amount(map.curve_measure)),
            })}
          </span>
        )}
      </div>
      <MapHead map={map} />
      <p class="hint">{about(map)}</p>
      <SummaryTable table={table} />
      <Footnotes map={map} />
    </>
  )
}

function about(map: MapAnalysis): string {
  const measure = t('lab.results.measured', { measure: measureWords(map.measure) })
  const optima = optimaOf(map).map(({ words }) => words)
  const known =
    optima.length > 0
      ? t('lab.results.optima', { optima: listed(optima) })
      : t('lab.results.noOptimum')
  return `${measure} ${known}`
}

function TargetChoice({ map, target }: { map: MapAnalysis; target: number }) {
  return (
    <Select
      label={t('lab.results.target')}
      value={String(target)}
      options={map.target_gaps.map((gap, i) => ({
        value: String(i),
        label:
          gap === 0
            ? t('lab.results.targetOptimum')
            : t('lab.results.withinGap', { gap: numbers.value.share.format(gap) }),
      }))}
      onChange={(value) => {
        chosenTarget.value = Number(value)
      }}
      testId="results-target"
    />
  )
}

function SummaryTable({ table }: { table: Table }) {
  const columns = columnsOf(table)
  const { entries } = table.map
  const rows = inOrder(entries, columns)
  const best = columns.map((column) => bestOf(entries.map(possible(column)), column.better))
  const caption = t('lab.results.tableOf', { what: table.map.name || table.map.id })
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="result-scroll" tabIndex={0} aria-label={caption}>
      <table class="result-table summary-table" data-testid="summary-table">
        <caption class="visually-hidden">{caption}</caption>
        <thead>
          <tr>
            <th scope="col">{t('lab.results.columns.entry')}</th>
            {columns.map((column) => (
              <Head key={column.id} column={column} table={table} />
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((index) => {
            const entry = entries[index]
            return (
              entry && (
                <Row
                  key={entry.id}
                  entry={entry}
                  index={index}
                  columns={columns}
                  best={best}
                  mixed={table.map.mixed_objectives}
                />
              )
            )
          })}
        </tbody>
      </table>
    </section>
  )
}

/** What is impossible is never the best. */
const possible = (column: Column) => (entry: EntryAnalysis) =>
  entry.impossible > 0 ? null : column.value(entry)

function Head({ column, table }: { column: Column; table: Table }) {
  const { id } = column
  const now = sorting.value?.column === id ? sorting.value : null
  const order = now ? (now.descending ? 'descending' : 'ascending') : undefined
  const { name, note, hint } = headOf(id, table)
  return (
    <th scope="col" aria-sort={order}>
      <button
        type="button"
        class="sort"
        title={hint}
        data-testid={`sort-${id}`}
        onClick={() => sortBy(column)}
      >
        {name}
        <span class="sort-mark" aria-hidden="true">
          {order === 'ascending' ? '▲' : order === 'descending' ? '▼' : ''}
        </span>
      </button>
      {note && <span class="cell-small">{note}</span>}
    </th>
  )
}

/** The better end first, then the other, then as it was. */
function sortBy({ id, better }: Column): void {
  const first = better === 'higher'
  const now = sorting.peek()
  if (now?.column !== id) sorting.value = { column: id, descending: first }
  else sorting.value = now.descending === first ? { column: id, descending: !first } : null
}

/** Indices of entries; those without a number come last, whichever way. */
function inOrder(entries: EntryAnalysis[], columns: Column[]): number[] {
  const order = entries.map((_, i) => i)
  const by = columns.find(({ id }) => id === sorting.value?.column)
  if (!by) return order
  const sign = sorting.value?.descending ? -1 : 1
  const worst = Number.POSITIVE_INFINITY
  const key = (i: number) => {
    const value = entries[i] && by.value(entries[i])
    return value == null ? worst : sign * value
  }
  return order.sort((a, b) => (key(a) === key(b) ? a - b : key(a) - key(b)))
}

interface RowProps {
  entry: EntryAnalysis
  index: number
  columns: Column[]
  best: Set<number>[]
  /** Whether entries make different things small. */
  mixed: boolean
}

function Row({ entry, index, columns, best, mixed }: RowProps) {
  return (
    <tr data-testid={`summary-${entry.id}`}>
      <th scope="row" style={{ '--panel-colour': dotColour(entry, index) }}>
        <span class="panel-dot" aria-hidden="true" />
        {labelOf(entry)}
        {mixed && entry.objective && (
          <span class="cell-small">
            {t('lab.matrix.makesSmall', { objective: t(`objective.${entry.objective}`) })}
          </span>
        )}
      </th>
      {entry.origin === 'missing' ? (
        <td class="not-run" colSpan={columns.length}>
          {t('lab.results.notRunWhy', { why: whyMissing(entry.id) })}
        </td>
      ) : (
        columns.map((column, c) => (
          <Cell
            key={column.id}
            column={column}
            entry={entry}
            isBest={best[c]?.has(index) ?? false}
          />
        ))
      )}
    </tr>
  )
}

const whyMissing = (id: string) =>
  shownComparison.value?.question.entries.find((entry) => entry.id === id)?.missing ?? ''

function Cell({
  column,
  entry,
  isBest,
}: {
  column: Column
  entry: EntryAnalysis
  isBest: boolean
}) {
  const hint = column.hint?.(entry)
  const note = column.note?.(entry)
  const failed = column.id === 'found' && entry.with_path < entry.runs
  return (
    <td
      class={isBest ? 'better' : failed ? 'failed' : undefined}
      title={hint ?? undefined}
      data-column={column.id}
    >
      {isBest ? <strong>{column.text(entry)}</strong> : column.text(entry)}
      {note && <span class="cell-small">{note}</span>}
      {hint && <span class="visually-hidden">. {hint}</span>}
    </td>
  )
}

function Footnotes({ map }: { map: MapAnalysis }) {
  const failed = map.entries.some(({ runs, with_path }) => with_path < runs)
  const wrong = map.entries.filter(({ impossible }) => impossible > 0)
  const shared = map.targets.length > 0 && optimaOf(map, map.curve_measure).length > 1
  return (
    <>
      {wrong.map((entry) => (
        <Alert
          key={entry.id}
          words={t('lab.results.impossibleRuns', {
            entry: labelOf(entry),
            count: entry.impossible,
          })}
        />
      ))}
      <ul class="footnotes">
        {failed && <li>{t('lab.results.failuresNote')}</li>}
        {shared && <li>{t('lab.results.targetsShared')}</li>}
        {wrong.length > 0 && <li>{t('lab.matrix.markNote')}</li>}
      </ul>
    </>
  )
}
