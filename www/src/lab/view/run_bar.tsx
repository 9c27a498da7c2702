/** How far the runs are, with the buttons to pause, go on and share. */
import { ArrowLeft, Pause, Play, Square, TriangleAlert } from 'lucide'
import { useEffect, useRef } from 'preact/hooks'
import { translated } from '../../i18n'
import { describeError } from '../../i18n/errors'
import { t } from '../../i18n/lab'
import { announce, notifyError } from '../../state'
import { embedding } from '../../state/embedding'
import { Button, IconButton } from '../../ui/buttons'
import { Icon } from '../../ui/icon'
import {
  analysis,
  analysisError,
  cancel,
  closeComparison,
  failures,
  finishing,
  goOn,
  openComparison,
  pause,
  phase,
  progress,
} from '../run/actions'
import { countWords } from '../run/count_words'
import { timeWords } from '../run/time_words'
import { ShareComparison } from '../share/share_comparison'

export function RunBar() {
  const now = openComparison.value
  const heading = useRef<HTMLHeadingElement>(null)
  const isRunning = phase.value === 'running'
  // The control that had the focus is gone.
  useEffect(() => heading.current?.focus({ preventScroll: true }), [now?.id])
  useAnnouncedEnd()
  if (!now) return null
  return (
    <section class="run-bar" aria-label={t('lab.run.region')} data-testid="run-bar">
      <div class="run-head">
        {!embedding && (
          <IconButton
            icon={ArrowLeft}
            label={t('lab.run.back')}
            testId="lab-back"
            onClick={() => (isRunning ? void cancel() : closeComparison())}
          />
        )}
        <h2 ref={heading} tabIndex={-1}>
          {translated(now.title)}
        </h2>
        <div class="run-actions">
          <Actions />
          {!embedding && <ShareComparison />}
        </div>
      </div>
      <ProgressBar />
      <p class="run-words" data-testid="run-words">
        {words().join(' · ')}
      </p>
      {now.elsewhere && <Elsewhere />}
      <Failures />
      <NoAnalysis />
    </section>
  )
}

function Actions() {
  if (phase.value === 'running')
    return (
      <>
        <Button icon={Pause} label={t('lab.run.pause')} testId="lab-pause" onClick={pause} />
        {!embedding && (
          <Button
            icon={Square}
            label={t('lab.run.cancel')}
            tone="quiet"
            testId="lab-cancel"
            onClick={() => void cancel()}
          />
        )}
      </>
    )
  // A share is begun from its own card.
  if (openComparison.value?.share && progress.value.done === 0) return null
  if (phase.value === 'paused')
    return (
      <Button
        icon={Play}
        label={t('lab.run.goOn')}
        tone="primary"
        testId="lab-go-on"
        disabled={openComparison.value?.elsewhere ?? false}
        onClick={() => goOn().catch(notifyError)}
      />
    )
  return null
}

function ProgressBar() {
  const { done, total } = progress.value
  return (
    <div
      class="progress"
      role="progressbar"
      aria-label={t('lab.run.region')}
      aria-valuemin={0}
      aria-valuemax={total}
      aria-valuenow={done}
      aria-valuetext={t('lab.run.progress', { done, total })}
      data-testid="lab-progress"
    >
      <span style={{ inlineSize: `${total > 0 ? (100 * done) / total : 0}%` }} />
    </div>
  )
}

function words(): string[] {
  const { done, total, kept, pathless, failed, secondsLeft } = progress.value
  const share = openComparison.value?.share ?? null
  if (share && share.index === null) return [t('lab.class.unchosen')]
  const said = [
    ...(share ? [t('lab.class.name', { share: share.index, of: share.of })] : []),
    phase.value === 'done'
      ? t('lab.run.complete', { count: total })
      : t('lab.run.progress', { done, total }),
  ]
  if (analysis.value) said.push(...countWords(analysis.value.counts))
  if (finishing.value > 0) said.push(t('lab.run.finishing', { count: finishing.value }))
  else if (phase.value === 'paused') said.push(t('lab.run.paused'))
  if (phase.value === 'running' && secondsLeft !== null) said.push(timeWords(secondsLeft, 'left'))
  if (kept > 0 && openComparison.value?.runs === 'own' && phase.value !== 'done')
    said.push(t('lab.run.kept', { count: kept }))
  if (pathless > 0) said.push(t('lab.run.pathless', { count: pathless }))
  if (failed > 0) said.push(t('lab.run.failed', { count: failed }))
  return said
}

function Elsewhere() {
  return (
    <p class="remark" role="status" data-testid="lab-elsewhere">
      {t('lab.run.elsewhere')}. {t('lab.run.elsewhereHint')}
    </p>
  )
}

function Failures() {
  const all = failures.value
  if (all.length === 0) return null
  return (
    <div class="run-failures" role="alert" data-testid="lab-failures">
      <p>
        <Icon icon={TriangleAlert} size={16} /> {t('lab.run.failures')}. {t('lab.run.tryAgain')}
      </p>
      <ul>
        {all.map(({ index, what, error }) => (
          <li key={index}>
            {t('lab.run.failure', { what, message: describeError(error).message })}
          </li>
        ))}
      </ul>
    </div>
  )
}

function NoAnalysis() {
  const error = analysisError.value
  if (!error) return null
  return (
    <p class="field-error" role="alert">
      {t('lab.run.failure', {
        what: t('lab.run.noAnalysis'),
        message: describeError(error).message,
      })}
    </p>
  )
}

/** Tells screen readers when the runs are done. */
function useAnnouncedEnd(): void {
  const before = useRef(phase.value)
  const now = phase.value
  useEffect(() => {
    if (before.current === 'running' && now === 'done') announce(t('lab.run.finished'))
    before.current = now
  }, [now])
}
