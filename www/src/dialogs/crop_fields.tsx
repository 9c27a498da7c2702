/** Numbers of the part that is taken of a raster or a picture. */
import { Crop as CropIcon } from 'lucide'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import type { Crop } from '../model/raster_part'
import { Button } from '../ui/buttons'
import { NumberField } from '../ui/fields'

interface CropFieldsProps {
  /** The whole, in cells or pixels. */
  whole: { width: number; height: number }
  crop: Crop
  /** Whether the part lies within. */
  fits: boolean
  /** Whether all of it is taken. */
  all: boolean
  legend: string
  hint?: string
  outside: 'raster.cropOutside' | 'mapFile.cropOutside'
  /** What the names of its fields begin with, for tests. */
  testId: string
  onChange: (crop: Crop) => void
  onWhole: () => void
}

export function CropFields(props: CropFieldsProps) {
  const { whole, crop, fits, all, legend, hint, outside, testId, onChange, onWhole } = props
  const sides = { x: whole.width, y: whole.height, width: whole.width, height: whole.height }
  const [width, height] = [whole.width, whole.height].map(numbers.value.whole.format)
  return (
    <fieldset class="field-set">
      <legend>{legend}</legend>
      <div class="field-row">
        {(['x', 'y', 'width', 'height'] as const).map((key) => (
          <NumberField
            key={key}
            label={t(`raster.crop.${key}`)}
            value={crop[key]}
            min={key === 'x' || key === 'y' ? 0 : 2}
            max={sides[key]}
            step={1}
            invalid={!fits}
            testId={`${testId}-${key}`}
            onChange={(value) => onChange({ ...crop, [key]: value })}
          />
        ))}
        <Button
          icon={CropIcon}
          label={t('raster.whole')}
          testId={`${testId}-whole`}
          disabled={all}
          onClick={onWhole}
        />
      </div>
      {!fits && (
        <p class="field-error" role="alert">
          {t(outside, { width, height })}
        </p>
      )}
      {fits && hint && <p class="hint">{hint}</p>}
    </fieldset>
  )
}
