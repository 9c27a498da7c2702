/** What is said of an obstacle or of walls beside the cells that are drawn. The engine says what it does not take. */
import type { AtEnd, Track } from '@pkg/formicarium'
import { t } from '../i18n/drive'
import { NumberField, Segmented, Select } from '../ui/fields'
import { changeStep, changeTrack, movingNow, paint, stepOfNew } from './moving'

const ENDS: readonly AtEnd[] = ['back-and-forth', 'loop', 'stay', 'leave']
/** For the arrows of a field alone: what the engine takes, it says itself. */
const MANY = 1e6

/** Of a new one nothing can be said before it has cells. */
export function TrackFields({ index }: { index: number | null }) {
  const track = index === null ? undefined : movingNow().tracks[index]
  if (index === null || !track) return null
  const number = (key: 'size' | 'from_step' | 'steps_per_cell', label: string, least: number) => (
    <NumberField
      label={label}
      value={track[key] ?? least}
      min={least}
      max={MANY}
      step={1}
      testId={`track-${key}`}
      onChange={(value) => void changeTrack(index, { [key]: value } satisfies Partial<Track>)}
    />
  )
  return (
    <div class="drive-grid">
      {number('size', t('drive.size'), 1)}
      {number('from_step', t('drive.fromStep'), 0)}
      {number('steps_per_cell', t('drive.stepsPerCell'), 1)}
      <Select
        label={t('drive.atEnd')}
        value={track.at_end ?? 'stay'}
        testId="track-at_end"
        options={ENDS.map((value) => ({ value, label: t(`drive.ends.${value}`) }))}
        onChange={(at_end) => void changeTrack(index, { at_end })}
      />
    </div>
  )
}

export function WallFields({ index }: { index: number | null }) {
  const change = index === null ? undefined : movingNow().changes[index]
  return (
    <div class="drive-grid">
      <NumberField
        label={t('drive.atStep')}
        value={change?.at_step ?? stepOfNew.value}
        min={0}
        max={MANY}
        step={1}
        nearest
        testId="walls-at_step"
        onChange={(value) => {
          stepOfNew.value = value
          if (index !== null) void changeStep(index, value)
        }}
      />
      <Segmented
        label={t('drive.paint')}
        value={paint.value}
        options={(['block', 'free'] as const).map((value) => ({
          value,
          label: t(`drive.${value}`),
          testId: `walls-${value}`,
        }))}
        onChange={(value) => {
          paint.value = value
        }}
      />
    </div>
  )
}
