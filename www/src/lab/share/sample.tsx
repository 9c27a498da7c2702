/** Repeats a sample of the runs that files have brought, and names those that come out otherwise. */
import { CheckCheck, CircleAlert, Square } from 'lucide'
import { useState } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { notifyError } from '../../state'
import { Button } from '../../ui/buttons'
import { Icon } from '../../ui/icon'
import { openComparison, phase } from '../run/actions'
import { removeBrought } from '../run/journals'
import { focusCollected } from './collected_focus'
import { differing, namesOfRun } from './run_words'
import { type ForgedRun, stopVerifying, type Verifying, verifying, verifySample } from './verifier'

const USUAL_PER_CENT = 2
/** More forged runs than these are only counted. */
const MOST_FORGED = 20

export function Sample() {
  const now = verifying.value?.of === 'class' ? verifying.value : null
  return (
    <div class="class-sample">
      <Begin isRunning={now?.isRunning ?? false} />
      {now?.isRunning && <Going now={now} />}
      {now && <Outcome now={now} />}
    </div>
  )
}

function Begin({ isRunning }: { isRunning: boolean }) {
  const [perCent, setPerCent] = useState(USUAL_PER_CENT)
  return (
    <div class="class-row">
      <Button
        icon={CheckCheck}
        label={t('lab.class.sample')}
        testId="class-sample"
        disabled={isRunning || phase.value === 'running'}
        onClick={() => verifySample(perCent / 100)}
      />
      <label class="class-number">
        {t('lab.class.sampleShare')}
        <input
          class="input"
          type="number"
          min={1}
          max={100}
          value={perCent}
          data-testid="class-sample-share"
          onInput={({ currentTarget: { valueAsNumber } }) => {
            if (valueAsNumber > 0) setPerCent(Math.min(valueAsNumber, 100))
          }}
        />
      </label>
      <p class="hint">{t('lab.class.sampleHint')}</p>
    </div>
  )
}

function Going({ now: { done, total } }: { now: Verifying }) {
  return (
    <div class="class-row">
      <p role="status" data-testid="class-sampling">
        {t('lab.class.sampling', { done, total })}
      </p>
      <Button icon={Square} label={t('lab.verify.stop')} tone="quiet" onClick={stopVerifying} />
    </div>
  )
}

function Outcome({ now }: { now: Verifying }) {
  const { done, total, failed, forged, isRunning } = now
  return (
    <>
      {failed > 0 && <p class="field-error">{t('lab.verify.failed', { count: failed })}</p>}
      {forged.length > 0 ? (
        <Forged forged={forged} total={done} />
      ) : (
        !isRunning &&
        done > 0 && (
          <p class="chip verification-good" role="status" data-testid="class-sampled">
            <Icon icon={CheckCheck} size={14} />
            {done + failed < total
              ? t('lab.class.stoppedAt', { done, total })
              : t('lab.class.sampled', { count: done })}
          </p>
        )
      )}
    </>
  )
}

function Forged({ forged, total }: { forged: ForgedRun[]; total: number }) {
  const files = openComparison.value?.brought ?? []
  const guilty = files.filter(({ key }) => forged.some(({ from }) => from === key))
  const nameOf = (from: number | null) => files.find(({ key }) => key === from)?.name ?? ''
  return (
    <div class="class-refused" role="alert" data-testid="class-forged">
      <p>
        <Icon icon={CircleAlert} size={16} />{' '}
        {t('lab.class.forged', { count: forged.length, total })}
      </p>
      <ul>
        {forged.slice(0, MOST_FORGED).map((run) => {
          const [said, came] = differing(run.row, run.came)
          return (
            <li key={run.index}>
              {t('lab.class.forgedRow', { file: nameOf(run.from), ...namesOfRun(run) })}
              <span class="hint">{t('lab.class.saysAndCame', { said, came })}</span>
            </li>
          )
        })}
        {forged.length > MOST_FORGED && (
          <li>{t('lab.class.more', { count: forged.length - MOST_FORGED })}</li>
        )}
      </ul>
      {guilty.map(({ key, name }) => (
        <Button
          key={key}
          label={t('lab.class.remove', { name })}
          testId="class-remove-forged"
          onClick={() => void removeBrought(key).then(focusCollected, notifyError)}
        />
      ))}
    </div>
  )
}
