import { Footprints, Pause, Play, RotateCcw, SkipForward, StepForward } from 'lucide'
import { t } from '../i18n'
import { panels, phase, reset, runToEnd, stepIteration, stepMove, toggle } from '../state'
import { IconButton } from '../ui/buttons'
import { Icon } from '../ui/icon'
import { Stops } from './stops'

export function Transport() {
  const idle = panels.value.length === 0
  const finished = phase.value === 'finished'
  return (
    <div class="toolbar-group transport" role="toolbar" aria-label={t('transport.group')}>
      <IconButton
        icon={RotateCcw}
        label={t('transport.reset')}
        keys="R"
        testId="reset"
        disabled={idle || phase.value === 'editing'}
        onClick={reset}
      />
      <PlayButton disabled={idle} />
      <IconButton
        icon={Footprints}
        label={t('transport.stepMove')}
        keys="→"
        testId="step-move"
        disabled={idle || finished}
        onClick={stepMove}
      />
      <IconButton
        icon={StepForward}
        label={t('transport.stepIteration')}
        keys="Shift+→"
        testId="step-iteration"
        disabled={idle || finished}
        onClick={stepIteration}
      />
      <IconButton
        icon={SkipForward}
        label={t('transport.toEnd')}
        keys="End"
        testId="run-to-end"
        disabled={idle || finished}
        onClick={runToEnd}
      />
      <Stops />
    </div>
  )
}

function PlayButton({ disabled }: { disabled: boolean }) {
  const running = phase.value === 'running'
  const words = running ? 'pause' : phase.value === 'finished' ? 'again' : 'play'
  return (
    <button
      type="button"
      class={phase.value === 'editing' ? 'play-button waiting' : 'play-button'}
      data-testid="play"
      data-phase={phase.value}
      data-tip={`${t(`transport.${words}`)} · ${t('transport.space')}`}
      disabled={disabled}
      onClick={toggle}
    >
      <Icon icon={running ? Pause : Play} />
      <span>{t(`transport.${words}`)}</span>
    </button>
  )
}
