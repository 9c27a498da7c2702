/** Drive, pause, one step, back to the start, and how fast. */
import { Pause, Play, RotateCcw, StepForward } from 'lucide'
import { t } from '../i18n/drive'
import { Button, IconButton } from '../ui/buttons'
import { Select } from '../ui/fields'
import { isOver, PACES, pace, restart, running, standing, step, toggle } from './drive'

export function Transport() {
  const going = running.value
  return (
    <div class="card-actions drive-transport">
      <Button
        icon={going ? Pause : Play}
        label={t(going ? 'drive.pause' : 'drive.play')}
        tone="primary"
        testId="drive-play"
        disabled={!standing.value}
        onClick={() => void toggle()}
      />
      <IconButton
        icon={StepForward}
        label={t('drive.step')}
        testId="drive-step"
        disabled={!standing.value || isOver.value}
        onClick={() => void step()}
      />
      <IconButton
        icon={RotateCcw}
        label={t('drive.restart')}
        testId="drive-restart"
        onClick={() => void restart()}
      />
      <span class="spacer" />
      <Select
        label={t('drive.pace')}
        hideLabel
        value={String(pace.value)}
        testId="drive-pace"
        note={t('drive.pace')}
        options={PACES.map((each) => ({ value: String(each), label: `${each} / s` }))}
        onChange={(each) => {
          pace.value = Number(each)
        }}
      />
    </div>
  )
}
