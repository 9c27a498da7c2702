/** What became of the claims: over maps, and below each claim on every map; and the maps that cannot stand for the paper's. */
import { ChevronDown, ChevronRight } from 'lucide'
import { useState } from 'preact/hooks'
import { language, numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Analysis, Measure, OverMaps, UnfitMap, VerdictLine } from '../../model/analysis'
import { IconButton } from '../../ui/buttons'
import { shownComparison } from '../store/shown_comparison'
import { amount, chance, dash, labelOf, measureWords, precise, share } from '../words/numbers'
import { whyWords } from '../words/verdict_words'
import { Chip, change, partOfMaps, size, whyNotOver, within } from './claim_cells'
import { ClaimsByReading, isOfShownReading, ReadingChoice, withReading } from './claims_by_reading'

/** Of so few maps all are shown at once. */
const FEW = 3

export function Claims({ analysis }: { analysis: Analysis }) {
  return (
    <>
      <Unfit analysis={analysis} />
      {analysis.over_maps.length > 0 && (
        <>
          <ReadingChoice analysis={analysis} />
          <ClaimsByReading analysis={analysis} />
          <ClaimsTable analysis={analysis} />
        </>
      )}
    </>
  )
}

function ClaimsTable({ analysis }: { analysis: Analysis }) {
  const caption = t('lab.results.claims')
  const columns = ['claim', 'maps', 'claimed', 'effect', 'verdict'] as const
  return (
    <section class="reported-map">
      <h3>{caption}</h3>
      <p class="hint">{t('lab.claims.hint')}</p>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="result-scroll" tabIndex={0} aria-label={caption}>
        <table class="result-table verdicts" data-testid="verdicts">
          <caption class="visually-hidden">{caption}</caption>
          <thead>
            <tr>
              {columns.map((key) => (
                <th key={key} scope="col">
                  {t(`lab.claims.columns.${key}`)}
                </th>
              ))}
            </tr>
          </thead>
          {analysis.over_maps.filter(isOfShownReading(analysis)).map((over) => (
            <Claim key={over.claim} over={over} analysis={analysis} />
          ))}
        </table>
      </section>
      <Reservations />
    </section>
  )
}

interface ClaimProps {
  over: OverMaps
  analysis: Analysis
}

/** The claim over its maps, and when it is unfolded each of them. */
function Claim({ over, analysis }: ClaimProps) {
  const lines = analysis.verdicts.filter(({ claim }) => claim === over.claim)
  const [open, setOpen] = useState(lines.length <= FEW)
  const label = (id: string) => entryLabel(analysis, id)
  return (
    <tbody data-testid={`claim-${over.claim}`}>
      <tr class="claim-over">
        <th scope="row">
          <span class="claim-head">
            <IconButton
              icon={open ? ChevronDown : ChevronRight}
              label={
                open
                  ? t('lab.claims.hideMaps', { claim: over.says })
                  : t('lab.claims.showMaps', { count: lines.length, claim: over.says })
              }
              tone="quiet"
              expanded={open}
              testId={`claim-maps-${over.claim}`}
              onClick={() => setOpen(!open)}
            />
            <span>{over.says}</span>
          </span>
          <span class="cell-small">
            {withReading(
              over,
              t('lab.results.claimOf', {
                improved: label(over.improved),
                baseline: label(over.baseline),
                measure: measureWords(over.measure),
              }),
            )}
          </span>
        </th>
        <td>
          {partOfMaps(over)}
          {over.maps > 0 && <span class="cell-small">{shareOf(over)}</span>}
          <span class="cell-small">{countsOf(over)}</span>
        </td>
        <td>
          {change(over, over.claimed)}
          <span class="cell-small">
            {t('lab.claims.atLeast', { effect: size(over, over.relevant) })}
          </span>
        </td>
        <td>
          {change(over, over.median)}
          {over.confidence !== null && (
            <span class="cell-small">{within(over, over.low, over.high)}</span>
          )}
          {over.sign_p !== null && (
            <span class="cell-small">
              {t('lab.claims.signs', {
                above: over.above,
                below: over.below,
                level: over.level,
                p: chance(over.sign_p),
              })}
            </span>
          )}
        </td>
        <td>
          <Chip verdict={over.verdict} />
          {over.verdict === 'cannot-tell' && (
            <span class="cell-small verdict-why">{whyNotOver(over, analysis)}</span>
          )}
        </td>
      </tr>
      {open &&
        lines.map((line) => (
          <MapRow key={line.instance} line={line} name={mapName(analysis, line.instance)} />
        ))}
    </tbody>
  )
}

function MapRow({ line, name }: { line: VerdictLine; name: string }) {
  const { improved_value: to, baseline_value: from, measure } = line
  const values =
    from === null && to === null ? '' : `${value(measure, from)} → ${value(measure, to)}`
  return (
    <tr class="claim-map">
      <th scope="row">{name}</th>
      <td>{values}</td>
      <td>{change(line, line.claimed)}</td>
      <td>
        {change(line, line.found)}
        {line.effect && (
          <span class="cell-small">{within(line, line.effect.low, line.effect.high)}</span>
        )}
      </td>
      <td>
        <Chip verdict={line.verdict} />
        {line.why && <span class="cell-small verdict-why">{whyWords(line.why)}</span>}
      </td>
    </tr>
  )
}

const shareOf = ({ share_interval: [low, high] }: OverMaps) =>
  t('lab.claims.share', { low: share(low), high: share(high) })

const COUNTS = [
  ['reproduced', 'reproduced'],
  ['direction', 'direction'],
  ['partly', 'partly'],
  ['equivalent', 'equivalent'],
  ['not', 'not'],
  ['opposite', 'opposite'],
  ['cannot_tell', 'cannot-tell'],
] as const

/** How often each verdict came out, where there is more than one map. */
function countsOf({ counts }: OverMaps): string {
  const told = COUNTS.filter(([count]) => counts[count] > 0)
  const words = told.map(([count, verdict]) =>
    t('lab.claims.counted', {
      count: counts[count],
      verdict: t(`lab.claims.verdicts.${verdict}`),
    }),
  )
  return words.length > 1 ? inList(words) : ''
}

const value = (measure: Measure, of: number | null) =>
  measure === 'running-time' && of === null ? t('lab.claims.never') : dash(of, amount(measure))

function entryLabel(analysis: Analysis, id: string): string {
  const entries = analysis.instances.flatMap((map) => map.entries)
  const entry = entries.find((one) => one.id === id)
  return entry ? labelOf(entry) : id
}

const mapName = ({ instances }: Analysis, id: string) =>
  instances.find((map) => map.id === id)?.name || id

/** A longer list of them is folded. */
const UNFIT_IN_SIGHT = 6

function Unfit({ analysis }: { analysis: Analysis }) {
  const { unfit } = analysis
  if (unfit.length === 0) return null
  return (
    <section class="reported-map" data-testid="unfit">
      <h3>{t('lab.claims.unfit')}</h3>
      <p class="hint">{t('lab.claims.unfitHint')}</p>
      <details open={unfit.length <= UNFIT_IN_SIGHT}>
        <summary>
          {t('lab.claims.unfitCount', { count: numbers.value.whole.format(unfit.length) })}
        </summary>
        <ul class="reservations">
          {unfit.map((map) => (
            <li key={`${map.instance} ${map.entry}`}>{unfitWords(map, analysis)}</li>
          ))}
        </ul>
      </details>
    </section>
  )
}

function unfitWords(map: UnfitMap, analysis: Analysis): string {
  const item = t('lab.claims.unfitItem', {
    map: mapName(analysis, map.instance),
    why: whyUnfit(map, analysis),
  })
  return map.says ? t('lab.claims.unfitSource', { item, source: map.says }) : item
}

function whyUnfit({ why, entry, found, demanded }: UnfitMap, analysis: Analysis): string {
  if (why === 'arrives') {
    return t('lab.claims.doesNotArrive', {
      entry: entry === null ? '' : entryLabel(analysis, entry),
      found: share(found ?? 0),
      demanded: share(demanded),
    })
  }
  return found === null
    ? t('lab.claims.noPath', { demanded: precise(demanded) })
    : t('lab.claims.optimumAbove', {
        found: numbers.value.length.format(found),
        demanded: precise(demanded),
      })
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
