/** How a terrain is looked at: contour lines, from above or in three dimensions, how much its heights are exaggerated. */
import { Mountain } from 'lucide'
import { useId } from 'preact/hooks'
import '../styles/relief.css'
import { numbers, t } from '../i18n'
import { inRelief, showContours, showRelief } from '../state/relief'
import { IconButton } from '../ui/buttons'
import { chooseStretch, stretch, stretches } from './shown_ground'

export function ReliefControls() {
  return (
    <>
      <IconButton
        icon={Mountain}
        label={t('relief.contours')}
        pressed={showContours.value}
        testId="show-contours"
        onClick={() => {
          showContours.value = !showContours.value
        }}
      />
      <fieldset class="view-switch" aria-label={t('relief.group')}>
        <Choice on={false} words="flat" />
        <Choice on={true} words="solid" />
      </fieldset>
      {inRelief.value && <Stretch />}
      {inRelief.value && (
        <p id="relief-help" class="visually-hidden">
          {t('relief.help')}
        </p>
      )}
    </>
  )
}

function Choice({ on, words }: { on: boolean; words: 'flat' | 'solid' }) {
  return (
    <button
      type="button"
      aria-pressed={inRelief.value === on}
      data-tip={`${t(`relief.${words}Hint`)} · 3`}
      data-testid={`view-${words}`}
      onClick={() => void showRelief(on)}
    >
      {t(`relief.${words}`)}
    </button>
  )
}

function Stretch() {
  const id = useId()
  const { least, most, step } = stretches.value
  const times = numbers.value.times.format(stretch.value)
  return (
    <span class="field stretch-field" data-tip={t('relief.stretch')}>
      <label for={id} class="visually-hidden">
        {t('relief.stretch')}
      </label>
      <input
        id={id}
        class="slider"
        type="range"
        min={least}
        max={most}
        step={step}
        value={stretch.value}
        aria-valuetext={t('relief.stretchTimes', { times })}
        data-testid="stretch"
        onInput={(event) => chooseStretch(event.currentTarget.valueAsNumber)}
      />
      <output for={id}>{times}×</output>
    </span>
  )
}
