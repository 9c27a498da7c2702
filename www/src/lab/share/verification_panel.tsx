/** How far recorded runs come out the same here, and the possible causes where they do not. */
import type { Recorded, Verification } from '@pkg/formicarium'
import { CheckCheck, CircleAlert, Square } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { notifyError } from '../../state'
import { Button } from '../../ui/buttons'
import { Icon } from '../../ui/icon'
import { goOn, openComparison, phase, verification } from '../run/actions'
import { CarriedRuns } from './carried_runs'
import { Deviations } from './deviations'
import { forgetVerifying, stopVerifying, verifyAgain, verifying } from './verifier'

const USUAL_SPOT = 3

export function VerificationPanel() {
  const now = openComparison.value
  // Verification of another comparison says nothing about this one.
  useEffect(() => forgetVerifying, [now?.id])
  if (!now || (!now.recorded && now.runs !== 'file')) return null
  const told = verification.value
  return (
    <section
      class="lab-card verification"
      aria-label={t('lab.verify.title')}
      data-testid="verification"
      data-state={told ? stateOf(told) : 'none'}
    >
      <div class="verification-head">
        <h3>{t('lab.verify.title')}</h3>
        {told && <Verdict told={told} />}
      </div>
      <p class="hint" data-testid="verification-recorded">
        {told && recordedWords(told, now.recorded as Recorded | null)}
      </p>
      {told && <Differences told={told} />}
      {now.runs !== 'file' && told?.runs === 0 && now.recorded && (
        <CarriedRuns recorded={now.recorded as Recorded} />
      )}
      {told && (now.runs === 'file' ? <FileActions of={told.of} /> : <LinkActions told={told} />)}
    </section>
  )
}

function recordedWords({ of }: Verification, recorded: Recorded | null): string {
  if (!recorded) return t('lab.verify.unknown', { count: of })
  return t('lab.verify.recorded', { count: of, engine: recorded.engine })
}

export type State = 'none' | 'same' | 'partly' | 'differs' | 'refuted'

/** What has come out so far. A possible cause alone is no difference: the runs may agree all the same. */
export function stateOf({ runs, of, refuted, deviations }: Verification): State {
  if (refuted) return 'refuted'
  if (deviations.some(({ kind }) => kind === 'bits')) return 'differs'
  if (runs === 0) return 'none'
  return runs < of ? 'partly' : 'same'
}

const TONES: Record<State, string> = {
  none: 'plain',
  same: 'good',
  partly: 'good',
  differs: 'warn',
  refuted: 'bad',
}

function Verdict({ told }: { told: Verification }) {
  const state = stateOf(told)
  const { runs, of } = told
  const words = {
    none: () => t('lab.verify.notYet'),
    same: () => t('lab.verify.same'),
    partly: () => t('lab.verify.partly', { runs, of }),
    differs: () => t('lab.verify.differs'),
    refuted: () => t('lab.verify.refuted'),
  }[state]()
  return (
    <strong class={`chip verification-${TONES[state]}`} role="status" data-testid="verified">
      {state !== 'none' && (
        <Icon icon={TONES[state] === 'good' ? CheckCheck : CircleAlert} size={14} />
      )}
      {words}
    </strong>
  )
}

function Differences({ told }: { told: Verification }) {
  const { deviations, refuted } = told
  if (deviations.length === 0) return null
  const state = stateOf(told)
  const isEdited = deviations.some(({ kind }) => kind === 'edited')
  const why = isEdited ? 'editedFile' : 'unexplained'
  const words = refuted ? why : state === 'differs' ? 'explained' : 'causesOnly'
  return (
    <>
      {(state !== 'none' || refuted) && <p>{t(`lab.verify.${words}`)}</p>}
      <Deviations all={deviations} />
    </>
  )
}

/** A link has no runs: they are done here, and kept. */
function LinkActions({ told }: { told: Verification }) {
  if (told.of === 0 || phase.value !== 'paused') return null
  return (
    <div class="verification-actions">
      <Button
        icon={CheckCheck}
        label={t('lab.verify.again')}
        tone="primary"
        testId="verify-again"
        onClick={() => void goOn().catch(notifyError)}
      />
      <p class="hint">{t('lab.verify.linkHint')}</p>
    </div>
  )
}

function FileActions({ of }: { of: number }) {
  const now = verifying.value?.of === 'file' ? verifying.value : null
  if (now?.isRunning)
    return (
      <div class="verification-actions">
        <p role="status" data-testid="verifying">
          {t('lab.verify.going', { done: now.done, total: now.total })}
        </p>
        <Button icon={Square} label={t('lab.verify.stop')} tone="quiet" onClick={stopVerifying} />
      </div>
    )
  return (
    <>
      {now && now.failed > 0 && (
        <p class="field-error">{t('lab.verify.failed', { count: now.failed })}</p>
      )}
      <Choices of={of} />
    </>
  )
}

function Choices({ of }: { of: number }) {
  const most = openComparison.value?.question.seeds.count ?? 1
  const [seeds, setSeeds] = useState(Math.min(USUAL_SPOT, most))
  const busy = phase.value === 'running'
  return (
    <div class="verification-actions">
      <Button
        icon={CheckCheck}
        label={t('lab.verify.allAgain', { count: of })}
        testId="verify-again"
        disabled={busy}
        onClick={() => verifyAgain(null)}
      />
      {most > 1 && (
        <>
          <Button
            label={t('lab.verify.spot')}
            testId="verify-spot"
            disabled={busy}
            onClick={() => verifyAgain(seeds)}
          />
          <label class="verification-seeds">
            {t('lab.verify.spotSeeds')}
            <input
              class="input"
              type="number"
              min={1}
              max={most}
              value={seeds}
              data-testid="verify-seeds"
              onInput={(event) => {
                const { valueAsNumber } = event.currentTarget
                if (valueAsNumber >= 1) setSeeds(Math.min(Math.floor(valueAsNumber), most))
              }}
            />
          </label>
          <p class="hint">{t('lab.verify.spotHint')}</p>
        </>
      )}
    </div>
  )
}
