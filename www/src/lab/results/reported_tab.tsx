/** What papers report beside what came out here: numbers, and claims with their verdicts. */
import { BookOpen } from 'lucide'
import { language, numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Analysis, EntryAnalysis, MapAnalysis, VerdictLine } from '../../model/analysis'
import { Button } from '../../ui/buttons'
import { METHODOLOGY, showCard } from '../../words/paper_cards'
import { shownComparison } from '../store/shown_comparison'
import {
  amount,
  dash,
  labelOf,
  measureWords,
  optimaOf,
  precise,
  range,
  share,
} from '../words/numbers'
import { whyWords } from '../words/verdict_words'
import { Alert, dotColour, MapHead } from './choices'
import { Strip, stripScale } from './run_strip'

export function hasReported({ instances, verdicts }: Analysis): boolean {
  return verdicts.length > 0 || instances.some((map) => reported(map).length > 0)
}

const reported = ({ entries }: MapAnalysis) =>
  entries.flatMap((entry, index) =>
    entry.published ? [{ entry, index, published: entry.published }] : [],
  )

type Reported = ReturnType<typeof reported>[number]

export function ReportedTab({ analysis }: { analysis: Analysis }) {
  const maps = analysis.instances.filter((map) => reported(map).length > 0)
  return (
    <>
      <div class="result-choices">
        <p class="hint">{t('lab.results.reportedHint')}</p>
        <Button
          icon={BookOpen}
          label={t('lab.results.methodology')}
          tone="quiet"
          testId="open-methodology"
          onClick={() => showCard(METHODOLOGY)}
        />
      </div>
      {maps.map((map) => (
        <ReportedMap key={map.id} map={map} />
      ))}
      {analysis.verdicts.length > 0 && <Verdicts analysis={analysis} />}
    </>
  )
}

function ReportedMap({ map }: { map: MapAnalysis }) {
  const rows = reported(map)
  const scale = stripScale(map)
  const columns = [
    'entry',
    'published',
    'ours',
    'distribution',
    'publishedTurns',
    'publishedIterations',
  ] as const
  const caption = t('lab.results.tableOf', { what: map.name || map.id })
  return (
    <section class="reported-map" data-testid={`reported-${map.id}`}>
      <MapHead map={map} />
      <Impossible rows={rows} map={map} />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="result-scroll" tabIndex={0} aria-label={caption}>
        <table class="result-table">
          <caption class="visually-hidden">{caption}</caption>
          <thead>
            <tr>
              {columns.map((key) => (
                <th key={key} scope="col" class={key === 'distribution' ? 'strip-head' : undefined}>
                  {t(`lab.results.columns.${key}`, { measure: measureWords(map.measure) })}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row) => (
              <ReportedRow key={row.entry.id} row={row} map={map} scale={scale} />
            ))}
          </tbody>
        </table>
      </section>
    </section>
  )
}

interface ReportedRowProps {
  row: Reported
  map: MapAnalysis
  scale: ReturnType<typeof stripScale>
}

function ReportedRow({ row, map, scale }: ReportedRowProps) {
  const { entry, index, published } = row
  const write = amount(map.measure)
  const against = (theirs: number | null, ours: number | null | undefined) =>
    theirs === null
      ? '–'
      : t('lab.results.against', {
          theirs: amount('turns')(theirs),
          ours: dash(ours, amount('turns')),
        })
  return (
    <tr>
      <th scope="row" style={{ '--panel-colour': dotColour(entry, index) }}>
        <span class="panel-dot" aria-hidden="true" />
        {labelOf(entry)}
      </th>
      <td class={published.impossible ? 'impossible' : undefined}>
        {dash(published.value, precise)}
      </td>
      <td>
        {dash(entry.summary?.median, write)}
        <span class="cell-small">{oursNote(entry, write)}</span>
      </td>
      <td class="strip-cell">
        {entry.runs > 0 && (
          <Strip entry={entry} index={index} scale={scale} optima={optimaOf(map)} />
        )}
        <span class="cell-small">{placeOf(row)}</span>
      </td>
      <td>{against(published.turns, entry.turns?.median)}</td>
      <td>{against(published.iterations, entry.iteration_of_best?.median)}</td>
    </tr>
  )
}

function oursNote(
  { summary, runs, with_path }: EntryAnalysis,
  write: (value: number) => string,
): string {
  if (runs === 0) return t('lab.results.notRun')
  if (!summary) return t('lab.results.noPath')
  const quartiles = range(summary.lower, summary.upper, write)
  return with_path < runs
    ? `${quartiles} · ${t('lab.results.of', { part: with_path, whole: runs })}`
    : quartiles
}

/** Where the published number lies among our runs. */
function placeOf({ published }: Reported): string {
  if (published.value === null || published.share_at_or_below === null) return ''
  if (published.below_all) return t('lab.results.belowAll')
  return t('lab.results.atOrBelow', { share: share(published.share_at_or_below) })
}

/** One box for all published numbers that are impossible here. */
function Impossible({ rows, map }: { rows: Reported[]; map: MapAnalysis }) {
  const write = amount(map.measure)
  const all = rows.flatMap(({ entry, published: { value, optimum, impossible } }) =>
    impossible && value !== null && optimum !== null
      ? [{ entry: labelOf(entry), value: precise(value), optimum: write(optimum) }]
      : [],
  )
  const [first, ...others] = all
  if (!first) return null
  if (others.length === 0) return <Alert words={t('lab.results.impossible', first)} />
  const items = all.map((one) => t('lab.results.impossibleItem', one))
  return <Alert words={t('lab.results.impossibleMany')} items={items} />
}

function Verdicts({ analysis }: { analysis: Analysis }) {
  const caption = t('lab.results.claims')
  const columns = ['claim', 'map', 'claimed', 'found', 'verdict'] as const
  return (
    <section class="reported-map">
      <h3>{caption}</h3>
      <p class="hint">{t('lab.results.sizesHint')}</p>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="result-scroll" tabIndex={0} aria-label={caption}>
        <table class="result-table verdicts" data-testid="verdicts">
          <caption class="visually-hidden">{caption}</caption>
          <thead>
            <tr>
              {columns.map((key) => (
                <th key={key} scope="col">
                  {t(`lab.results.columns.${key}`)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {analysis.verdicts.map((line) => (
              <Verdict key={`${line.claim} ${line.instance}`} line={line} analysis={analysis} />
            ))}
          </tbody>
        </table>
      </section>
      <Reservations />
    </section>
  )
}

/** Reservations about the verdicts, each once, with the claims it is about. */
function Reservations() {
  const claims = shownComparison.value?.question.claims ?? []
  const notes = [...new Set(claims.map(({ note }) => note ?? ''))].filter((note) => note !== '')
  if (notes.length === 0) return null
  return (
    <ul class="reservations" aria-label={t('lab.results.reservations')} data-testid="reservations">
      {notes.map((note) => (
        <li key={note}>
          <b>{inList(claims.filter((claim) => claim.note === note).map(({ says }) => says))}</b>
          {note}
        </li>
      ))}
    </ul>
  )
}

const inList = (words: string[]) =>
  new Intl.ListFormat(language.value, { type: 'unit', style: 'long' }).format(new Set(words))

function Verdict({ line, analysis }: { line: VerdictLine; analysis: Analysis }) {
  const map = analysis.instances.find(({ id }) => id === line.instance)
  const label = (id: string) => {
    const entry = map?.entries.find((one) => one.id === id)
    return entry ? labelOf(entry) : id
  }
  const { improved_value: to, baseline_value: from } = line
  const values = from === null && to === null ? '' : `${dash(from, number)} → ${dash(to, number)}`
  return (
    <tr>
      <th scope="row">
        {line.says}
        <span class="cell-small">
          {t('lab.results.claimOf', {
            improved: label(line.improved),
            baseline: label(line.baseline),
            measure: measureWords(line.measure),
          })}
        </span>
      </th>
      <td>{map?.name || line.instance}</td>
      <td>{dash(line.claimed, percent)}</td>
      <td>
        {dash(line.found, percent)}
        {values && <span class="cell-small">{values}</span>}
      </td>
      <td>
        <span class={`chip verdict-${line.verdict}`}>
          {t(`lab.results.verdicts.${line.verdict}`)}
        </span>
        {line.why && <span class="cell-small verdict-why">{whyWords(line.why)}</span>}
      </td>
    </tr>
  )
}

const percent = (value: number) => numbers.value.percent.format(value)
const number = (value: number) => numbers.value.metres.format(value)
