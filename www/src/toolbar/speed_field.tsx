import { useId } from 'preact/hooks'
import { t } from '../i18n'
import { SPEEDS } from '../model/session'
import { chooseSpeed, speed } from '../state'

export function SpeedField() {
  const id = useId()
  const name = speedName(speed.value)
  return (
    <span class="field speed-field">
      <label for={id} class="field-label">
        {t('run.speed')}
      </label>
      <input
        id={id}
        class="slider"
        type="range"
        min={0}
        max={SPEEDS.length - 1}
        step={1}
        value={speed.value}
        aria-valuetext={name}
        data-testid="speed"
        onInput={(event) => chooseSpeed(event.currentTarget.valueAsNumber)}
      />
      <output class="speed-name" for={id}>
        {name}
      </output>
    </span>
  )
}

function speedName(index: number): string {
  const entry = SPEEDS[index]
  if (!entry || entry.unit === 'max') return t('run.speeds.max')
  const { unit, count, everyFrames } = entry
  if (everyFrames > 1) return t('run.speeds.slow', { frames: everyFrames })
  return t(unit === 'move' ? 'run.speeds.moves' : 'run.speeds.iterations', { count })
}
