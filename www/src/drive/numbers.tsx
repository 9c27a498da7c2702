/** What the drive comes to, and what the map shows of it. */
import { numbers } from '../i18n'
import { type DriveKey, t } from '../i18n/drive'
import { movingOf } from '../model/moving'
import { scenario } from '../state'
import { lengthShown } from '../words/lengths'
import { isSearch } from '../words/planner_words'
import { drivingPanel, isOver, standing, summary, tally } from './drive'

export function Numbers() {
  const { whole, length } = numbers.value
  const { waits, plans, expansions, antMoves } = tally.value
  const found = summary.value
  const last = standing.value?.last
  const [driven, cost, seconds] = [last?.length ?? 0, last?.cost, found?.travel_time]
  const replans = Math.max(0, plans - 1)
  const searches = isSearch(drivingPanel.value?.setup.planner ?? '')
  return (
    <dl class="drive-numbers" aria-label={t('drive.numbers')} data-testid="drive-numbers">
      <Fact name="length" text={lengthShown(driven)} value={driven} />
      {cost !== undefined && (
        <Fact name="cost" hint="drive.costHint" text={lengthShown(cost)} value={cost} />
      )}
      <Fact name="best" hint={reasonOr('drive.bestHint')} text={bestWords()} value={bestOf()} />
      <Fact
        name="ratio"
        hint="drive.ratioHint"
        text={found?.ratio == null ? '–' : length.format(found.ratio)}
        value={found?.ratio ?? ''}
      />
      <Fact
        name="arrival"
        hint="drive.arrivalHint"
        text={seconds === undefined ? '–' : t('drive.seconds', { seconds: length.format(seconds) })}
        value={seconds ?? ''}
      />
      <Fact name="replans" text={whole.format(replans)} value={replans} />
      <Fact name="waits" text={whole.format(waits)} value={waits} />
      {searches ? (
        <Fact name="expansions" text={whole.format(expansions)} value={expansions} />
      ) : (
        <Fact name="antMoves" text={whole.format(antMoves)} value={antMoves} />
      )}
    </dl>
  )
}

type Name =
  | 'length'
  | 'cost'
  | 'best'
  | 'ratio'
  | 'arrival'
  | 'replans'
  | 'waits'
  | 'expansions'
  | 'antMoves'

interface FactProps {
  name: Name
  hint?: DriveKey
  text: string
  value: number | string
}

function Fact({ name, hint, text, value }: FactProps) {
  return (
    <div title={hint && t(hint)}>
      <dt>{t(`drive.${name}`)}</dt>
      <dd data-testid={`drive-${name}`} data-value={value}>
        {text}
      </dd>
    </div>
  )
}

function bestOf(): number | string {
  const best = summary.value?.clairvoyant
  return best && 'value' in best ? best.value : ''
}

function bestWords(): string {
  if (!isOver.value) return t('drive.later')
  const best = summary.value?.clairvoyant
  if (!best) return t('drive.working')
  if ('value' in best) return lengthShown(best.value)
  return t(best.kind === 'no-path' ? 'drive.noPath' : 'drive.unknown')
}

/** Why the best in advance is not known, or else this. */
function reasonOr(otherwise: DriveKey): DriveKey {
  const why = summary.value?.too_much?.kind
  return why ? `drive.tooMuch.${why}` : otherwise
}

/** Only what can be there. */
export function MapKey() {
  const now = scenario.value
  const { tracks, changes, sight } = now ? movingOf(now) : { tracks: [], changes: [], sight: null }
  const shown = [
    'way' as const,
    'plan' as const,
    ...(tracks.length > 0 ? (['obstacle'] as const) : []),
    ...(changes.length > 0 ? (['walls'] as const) : []),
    ...(sight == null ? [] : (['believed-blocked', 'believed-free'] as const)),
  ]
  return (
    <ul class="drive-key" aria-label={t('drive.key')}>
      {shown.map((what) => (
        <li key={what}>
          <span class={`swatch ${what}`} aria-hidden="true" />
          {t(`drive.keys.${what}`)}
        </li>
      ))}
    </ul>
  )
}
