/** Somebody's share of a class: which it is, what is to be done, and the file to hand in. */
import { Dices, FileDown, ImageDown, Play } from 'lucide'
import { useEffect, useRef } from 'preact/hooks'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { ShareOfClass } from '../../share/share_of_class'
import { notifyError } from '../../state'
import { download } from '../../state/export_files'
import { Button } from '../../ui/buttons'
import { goOn, openComparison, phase, progress } from '../run/actions'
import { chooseShare, journalOfShare, runsOfQuestion } from '../run/shares'
import { shareCard } from './result_card'

type Stage = 'choosing' | 'ready' | 'begun' | 'done'

export function ShareCard() {
  const now = openComparison.value
  if (!now?.share) return null
  const { share } = now
  const stage = stageOf(share)
  return (
    <section
      class="lab-card class-card"
      aria-label={t('lab.class.card')}
      data-testid="share-card"
      data-stage={stage}
    >
      <h3>{t('lab.class.card')}</h3>
      <p class="hint">
        {t('lab.class.cardWhat', {
          runs: numbers.value.whole.format(runsOfQuestion().all),
          of: numbers.value.whole.format(share.of),
        })}
      </p>
      {(stage === 'choosing' || stage === 'ready') && <Choice share={share} />}
      {stage === 'ready' && <Begin share={share} />}
      {(stage === 'begun' || stage === 'done') && (
        <HandIn share={share} isDone={stage === 'done'} />
      )}
    </section>
  )
}

function stageOf({ index }: ShareOfClass): Stage {
  if (index === null) return 'choosing'
  if (phase.value === 'done') return 'done'
  return progress.value.done > 0 || phase.value === 'running' ? 'begun' : 'ready'
}

const choose = (share: ShareOfClass | null) => void chooseShare(share).catch(notifyError)

function Choice({ share: { index, of } }: { share: ShareOfClass }) {
  return (
    <div class="class-row">
      <label class="class-number">
        {t('lab.class.which')}
        <input
          class="input"
          type="number"
          min={1}
          max={of}
          value={index ?? ''}
          data-testid="share-number"
          onChange={({ currentTarget: field }) => {
            const chosen = field.valueAsNumber
            if (Number.isInteger(chosen) && chosen >= 1 && chosen <= of)
              choose({ index: chosen, of })
            else field.value = String(index ?? '')
          }}
        />
        <span class="hint">{t('lab.class.whichHint', { of })}</span>
      </label>
      <Button
        icon={Dices}
        label={t('lab.class.draw')}
        testId="share-draw"
        onClick={() => choose({ index: 1 + Math.floor(Math.random() * of), of })}
      />
      <Button
        label={t('lab.class.leave')}
        tone="quiet"
        testId="share-leave"
        onClick={() => choose(null)}
      />
    </div>
  )
}

function Begin({ share }: { share: ShareOfClass }) {
  const { total: count } = progress.value
  return (
    <div class="class-row">
      <Button
        icon={Play}
        label={t('lab.class.start')}
        tone="primary"
        testId="share-start"
        disabled={openComparison.value?.elsewhere ?? false}
        onClick={() => void goOn().catch(notifyError)}
      />
      <strong role="status" data-testid="share-is">
        {t('lab.class.yours', { share: share.index, of: share.of, count })}
      </strong>
      <p class="hint">{t('lab.class.startHint')}</p>
    </div>
  )
}

function HandIn({ share, isDone }: { share: ShareOfClass; isDone: boolean }) {
  const { done, total } = progress.value
  const words = useRef<HTMLParagraphElement>(null)
  // The button that began it is gone, with the focus.
  useEffect(() => {
    if (document.activeElement === document.body) words.current?.focus()
  }, [])
  return (
    <>
      <p ref={words} tabIndex={-1} role="status" data-testid="share-is">
        {isDone
          ? t('lab.class.complete', { share: share.index, of: share.of })
          : t('lab.class.doneOf', { done, total })}
      </p>
      {phase.value !== 'running' && <Save isDone={isDone} />}
    </>
  )
}

function Save({ isDone }: { isDone: boolean }) {
  return (
    <div class="class-row">
      <Button
        icon={FileDown}
        label={t(isDone ? 'lab.class.save' : 'lab.class.savePart')}
        tone={isDone ? 'primary' : 'plain'}
        testId="share-save"
        onClick={() => void save().catch(notifyError)}
      />
      <Button
        icon={ImageDown}
        label={t('lab.class.savePicture')}
        tone="quiet"
        testId="share-picture"
        onClick={() => void savePicture().catch(notifyError)}
      />
      <p class="hint">{t('lab.class.next')}</p>
    </div>
  )
}

async function save(): Promise<void> {
  const journal = await journalOfShare()
  if (journal) download(journal.name, journal.text, 'application/x-ndjson')
}

async function savePicture(): Promise<void> {
  const journal = await journalOfShare()
  if (journal)
    download(journal.name.replace(/journal$/, 'png'), await shareCard(journal.text), 'image/png')
}
