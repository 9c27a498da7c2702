/** What a comparison that was sent is. */

import type { Recorded } from '@pkg/formicarium'
import { CheckCheck, Eye } from 'lucide'
import { Citation, Facts, Offer, Section } from '../../dialogs/about_parts'
import { numbers } from '../../i18n'
import { t } from '../../i18n/about'
import { engineVersion, notifyError, showView } from '../../state'
import { closeDialog } from '../../state/dialogs'
import { goOn, openComparison, phase, verification } from '../run/actions'
import { shownComparison } from '../store/shown_comparison'
import { stateOf } from './verification_panel'

export function AboutComparison() {
  if (!shownComparison.value) return null
  return (
    <>
      <Sent />
      <Verified />
      <Section title={t('about.gap.title')}>
        <p>{t('about.gap.many')}</p>
      </Section>
      <Next />
      <Citation text={citation()} />
    </>
  )
}

const recorded = () => openComparison.value?.recorded as Recorded | null

function Sent() {
  const now = shownComparison.value
  if (!now) return null
  const { instances, entries, seeds } = now.question
  const { whole } = numbers.value
  return (
    <Section title={t('about.sent.title')}>
      <p class="about-name" dir="auto">
        {now.title}
      </p>
      {now.question.asks && <p class="about-note">{now.question.asks}</p>}
      <p>{t('about.sent.comparison')}</p>
      <Facts
        facts={[
          [t('about.sent.maps'), whole.format(instances.length)],
          [t('about.sent.planners'), entries.map(({ label }) => label).join(', ')],
          [t('about.sent.seeds'), whole.format(seeds.count)],
          [t('about.sent.recorded'), recordedWords()],
        ]}
      />
    </Section>
  )
}

function recordedWords(): string {
  const count = verification.value?.of ?? 0
  const engine = recorded()?.engine ?? engineVersion.value
  if (count === 0) return t('about.sent.noRuns')
  return t('about.sent.runs', { count: numbers.value.whole.format(count), engine })
}

function Verified() {
  const told = verification.value
  const state = told && told.of > 0 ? stateOf(told) : 'nothing'
  const words = {
    nothing: 'nothing',
    none: 'notYet',
    same: 'all',
    partly: 'partly',
    differs: 'differs',
    refuted: 'differs',
  } as const
  const { whole } = numbers.value
  const args = told && { runs: whole.format(told.runs), of: whole.format(told.of) }
  return (
    <Section title={t('about.verified.title')}>
      <p class="about-answer" role="status" data-testid="about-verified">
        {t(`about.verified.${words[state]}`, args ?? {})}
      </p>
      <p class="hint">{t('about.verified.how')}</p>
    </Section>
  )
}

function Next() {
  const canRun = openComparison.value?.runs === 'own' && phase.value === 'paused'
  return (
    <Section title={t('about.next.title')}>
      <ul class="about-offers">
        {canRun && (
          <Offer
            icon={CheckCheck}
            label={t('about.next.run')}
            hint={t('about.next.runHint')}
            testId="about-run"
            onClick={() => {
              closeDialog()
              void goOn().catch(notifyError)
            }}
          />
        )}
        <Offer
          icon={Eye}
          label={t('about.next.watch')}
          hint={t('about.next.watchHint')}
          testId="about-watch"
          onClick={() => {
            closeDialog()
            showView('race')
          }}
        />
      </ul>
    </Section>
  )
}

function citation(): string {
  const now = shownComparison.value
  const { instances = [], entries = [], seeds } = now?.question ?? {}
  return t('about.cite.comparison', {
    engine: recorded()?.engine ?? engineVersion.value,
    title: now?.title ?? '',
    maps: instances.length,
    entries: entries.length,
    seeds: seeds?.count ?? 0,
    digest: openComparison.value?.digest ?? '',
  })
}
