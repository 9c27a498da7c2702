import { Footprints, Pause, Play, RotateCcw, SkipForward, StepForward } from 'lucide'
import { t } from '../i18n'
import { panels, phase, reset, runOn, runToEnd, stepIteration, stepMove, toggle } from '../state'
import { IconButton } from '../ui/buttons'
import { Icon } from '../ui/icon'
import { Stops } from './stops'

interface TransportProps {
  plays?: boolean
  /** Beside playing: single moves, iterations, the end. */
  steps?: boolean
  /** The menu of stops; without it the way to the end is to the first of them. */
  stops?: boolean
}

export function Transport({ plays = true, steps = true, stops = true }: TransportProps) {
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
      {plays && <PlayButton disabled={idle} />}
      {steps && <Steps disabled={idle || finished} toEnd={stops ? runToEnd : () => runOn(false)} />}
      {stops && <Stops />}
    </div>
  )
}

function Steps({ disabled, toEnd }: { disabled: boolean; toEnd: () => void }) {
  return (
    <>
      <IconButton
        icon={Footprints}
        label={t('transport.stepMove')}
        keys="→"
        testId="step-move"
        disabled={disabled}
        onClick={stepMove}
      />
      <IconButton
        icon={StepForward}
        label={t('transport.stepIteration')}
        keys="Shift+→"
        testId="step-iteration"
        disabled={disabled}
        onClick={stepIteration}
      />
      <IconButton
        icon={SkipForward}
        label={t('transport.toEnd')}
        keys="End"
        testId="run-to-end"
        disabled={disabled}
        onClick={toEnd}
      />
    </>
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
