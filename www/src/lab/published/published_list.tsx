/** Questions of the papers, ready to run: what a paper reports beside what comes out in this browser. */
import '../../styles/lab_share.css'
import { BookOpen, Play } from 'lucide'
import { useState } from 'preact/hooks'
import { numbers, translated } from '../../i18n'
import { t } from '../../i18n/lab'
import { galleryId, notifyError } from '../../state'
import { IconButton } from '../../ui/buttons'
import { Icon } from '../../ui/icon'
import { Reserved } from '../../ui/reserved'
import { showCard } from '../../words/paper_cards'
import { startComparison } from '../run/actions'
import { documentFor, type PaperQuestion, questionOfMap, questions, secondsFor } from './questions'

/** With fewer seeds no verdict can be given (docs/methodology.md). */
const LEAST_SEEDS = 30

export function PublishedList() {
  const here = questionOfMap(galleryId.value)
  const inOrder = [...questions].sort((a, b) => Number(b === here) - Number(a === here))
  return (
    <section
      class="lab-card published"
      aria-label={t('lab.published.title')}
      data-testid="published"
    >
      <h3>{t('lab.published.title')}</h3>
      <p class="hint">{t('lab.published.text')}</p>
      <ul>
        {inOrder.map((question) => (
          <Published key={question.id} question={question} here={question === here} />
        ))}
      </ul>
    </section>
  )
}

function Published({ question, here }: { question: PaperQuestion; here: boolean }) {
  const { id, maps, entries, runs, card } = question
  const [seeds, setSeeds] = useState(Math.min(LEAST_SEEDS, question.seeds))
  const [busy, setBusy] = useState(false)
  const title = translated(question.title)
  const run = async () => {
    setBusy(true)
    await documentFor(question, seeds)
      .then((document) => startComparison(document))
      .catch(notifyError)
    setBusy(false)
  }
  return (
    <li class={here ? 'published-item here' : 'published-item'} data-testid={`published-${id}`}>
      <p class="published-title">
        <strong>{title}</strong>
        {here && <span class="chip">{t('lab.published.ofThisMap')}</span>}
      </p>
      <p class="hint">{asksOf(question)}</p>
      <p class="hint">
        {t('lab.published.size', {
          maps: t('lab.published.maps', { count: maps.length }),
          entries: t('lab.published.entries', { count: entries }),
          runs: t('lab.published.runs', {
            count: runs * seeds,
            shown: numbers.value.whole.format(runs * seeds),
          }),
        })}
        {' · '}
        {timeWords(secondsFor(question, seeds))}
      </p>
      <div class="published-actions">
        <span class="published-seeds">
          <span aria-hidden="true">{t('lab.published.seeds')}</span>
          <Seeds most={question.seeds} value={seeds} title={title} id={id} onChange={setSeeds} />
        </span>
        {card && (
          <IconButton
            icon={BookOpen}
            label={t('lab.published.card', { title })}
            tone="quiet"
            testId={`published-card-${id}`}
            onClick={() => showCard(card)}
          />
        )}
        <button
          type="button"
          class={here ? 'button primary' : 'button'}
          aria-label={t('lab.published.runOf', { title })}
          data-testid={`published-run-${id}`}
          disabled={busy}
          aria-busy={busy}
          onClick={() => void run()}
        >
          <Icon icon={Play} size={16} />
          <span>{t('lab.published.run')}</span>
        </button>
      </div>
      <Reserved shown={seeds < LEAST_SEEDS}>
        {t('lab.published.fewer', { count: LEAST_SEEDS })}
      </Reserved>
    </li>
  )
}

interface SeedsProps {
  most: number
  value: number
  title: string
  id: string
  onChange: (seeds: number) => void
}

function Seeds({ most, value, title, id, onChange }: SeedsProps) {
  return (
    <input
      class="input"
      type="number"
      min={1}
      max={most}
      value={value}
      aria-label={t('lab.published.seedsOf', { title })}
      data-testid={`published-seeds-${id}`}
      onInput={(event) => {
        const { valueAsNumber } = event.currentTarget
        if (valueAsNumber >= 1) onChange(Math.min(Math.floor(valueAsNumber), most))
      }}
    />
  )
}

/** Rounded to half minutes. */
function timeWords(seconds: number): string {
  const { whole } = numbers.value
  if (seconds < 90) {
    const count = Math.max(1, Math.ceil(seconds / 5) * 5)
    return t('lab.published.seconds', { count: whole.format(count) })
  }
  return t('lab.published.minutes', { count: whole.format(Math.round(seconds / 60)) })
}

type QuestionId = 'ship'

/** In few words; of a question that has none here, where it comes from. */
function asksOf({ id, paper }: PaperQuestion): string {
  return t(`lab.published.asks.${id as QuestionId}`, { defaultValue: translated(paper) })
}
