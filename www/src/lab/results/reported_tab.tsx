/** What papers report beside what came out here: numbers, and claims with their verdicts. */
import { BookOpen } from 'lucide'
import { t } from '../../i18n/lab'
import type { Analysis, EntryAnalysis, MapAnalysis } from '../../model/analysis'
import { Button } from '../../ui/buttons'
import { METHODOLOGY, showCard } from '../../words/paper_cards'
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
import { Alert, dotColour, MapHead } from './choices'
import { Claims } from './claims'
import { Strip, stripScale } from './run_strip'

export function hasReported({ instances, verdicts, unfit }: Analysis): boolean {
  return (
    verdicts.length > 0 || unfit.length > 0 || instances.some((map) => reported(map).length > 0)
  )
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
      <Claims analysis={analysis} />
      {maps.map((map) => (
        <ReportedMap key={map.id} map={map} />
      ))}
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
