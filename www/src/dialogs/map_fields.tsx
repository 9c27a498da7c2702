/** The controls of maps that leave a choice. */
import type { MatrixInfo } from '@pkg/formicarium'
import { useId } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { type Crop, WATCHED_SIDE, wholeOf } from '../model/raster_part'
import { MOST_FACTOR, PLAIN } from '../model/weights'
import { Button } from '../ui/buttons'
import { Labelled, NumberField, Segmented, Select } from '../ui/fields'
import { CropFields } from './crop_fields'
import { type choicesFit, cropped, longest, type MapChoices, type Sides } from './map_choices'
import { useRested } from './rested'

interface MatrixProps {
  matrices: MatrixInfo[]
  chosen: number
  onChange: (matrix: number) => void
}

export function MatrixField({ matrices, chosen, onChange }: MatrixProps) {
  return (
    <Select
      class="matrix-field"
      label={t('mapFile.matrix', { count: matrices.length })}
      value={String(chosen)}
      testId="map-matrix"
      options={matrices.map(({ number, name, width, height, line }) => ({
        value: String(number),
        label: [
          `${number}`,
          name,
          `${width} × ${height}`,
          t('mapFile.fromLine', { line: String(line) }),
        ]
          .filter((part) => part !== '')
          .join(' · '),
      }))}
      onChange={(number) => onChange(Number(number))}
    />
  )
}

interface FieldsProps {
  choices: MapChoices
  fits: ReturnType<typeof choicesFit>
  /** Its size in pixels or cells, once it is known. */
  whole: Sides | null
  onChange: (changed: Partial<MapChoices>) => void
}

/** `used`: the threshold of the last reading. */
export function PictureFields(props: FieldsProps & { used: number | null }) {
  const { choices, fits, whole, used, onChange } = props
  const id = useId()
  const threshold = choices.threshold ?? used ?? 128
  const setMetres = (metresPerCell: number) => onChange({ metresPerCell })
  return (
    <>
      <fieldset class="field-set">
        <legend>{t('mapFile.walls')}</legend>
        <div class="field-row">
          <span class="field threshold-field">
            <label for={id} class="field-label">
              {t('mapFile.threshold')}
            </label>
            <span class="threshold">
              <input
                id={id}
                class="slider"
                type="range"
                min={0}
                max={255}
                step={1}
                value={threshold}
                data-testid="map-threshold"
                onInput={(event) => onChange({ threshold: event.currentTarget.valueAsNumber })}
              />
              <output for={id}>{threshold}</output>
            </span>
          </span>
          <Button
            label={t('mapFile.chooseThreshold')}
            tone={choices.threshold === null ? 'primary' : 'plain'}
            pressed={choices.threshold === null}
            testId="map-threshold-auto"
            onClick={() => onChange({ threshold: choices.threshold === null ? threshold : null })}
          />
          <Labelled label={t('mapFile.blockedSide')}>
            <Segmented
              label={t('mapFile.blockedSide')}
              value={choices.lightIsBlocked ? 'light' : 'dark'}
              options={(['dark', 'light'] as const).map((side) => ({
                value: side,
                label: t(`mapFile.sides.${side}`),
                testId: `map-${side}`,
              }))}
              onChange={(side) => onChange({ lightIsBlocked: side === 'light' })}
            />
          </Labelled>
        </div>
      </fieldset>
      <fieldset class="field-set">
        <legend>{t('raster.cells')}</legend>
        <div class="field-row">
          <CellsField choices={choices} fits={fits} whole={whole} onChange={onChange} longer />
          <NumberField
            label={t('mapFile.metres')}
            value={choices.metresPerCell}
            min={0.001}
            max={1e6}
            invalid={!fits.metres}
            testId="map-metres"
            onChange={setMetres}
            onType={useRested(setMetres)}
          />
        </div>
        <CellsHint choices={choices} whole={whole} fits={fits} />
        {!fits.metres && (
          <p class="field-error" role="alert" data-testid="map-metres-wrong">
            {t('mapFile.metresOutside')}
          </p>
        )}
      </fieldset>
      {whole && <PixelCrop choices={choices} fits={fits} whole={whole} onChange={onChange} />}
    </>
  )
}

export function RobotFields(props: FieldsProps) {
  const { choices, onChange } = props
  return (
    <>
      <fieldset class="field-set">
        <legend>{t('mapFile.unknown')}</legend>
        <div class="field-row">
          <Segmented
            label={t('mapFile.unknown')}
            value={choices.unknown}
            options={(['blocked', 'free'] as const).map((as) => ({
              value: as,
              label: t(`mapFile.unknownAs.${as}`),
              testId: `map-unknown-${as}`,
            }))}
            onChange={(unknown) => onChange({ unknown })}
          />
        </div>
        <p class="hint">{t(`mapFile.unknownNotes.${choices.unknown}`)}</p>
      </fieldset>
      <fieldset class="field-set">
        <legend>{t('mapFile.extent')}</legend>
        <div class="field-row">
          <Segmented
            label={t('mapFile.extent')}
            value={choices.knownOnly ? 'known' : 'all'}
            options={(['all', 'known'] as const).map((extent) => ({
              value: extent,
              label: t(`mapFile.extents.${extent}`),
              testId: `map-extent-${extent}`,
            }))}
            onChange={(extent) => onChange({ knownOnly: extent === 'known' })}
          />
        </div>
        <p class="hint">{t('mapFile.extentHint')}</p>
      </fieldset>
      <CostsFields choices={choices} onChange={onChange} />
      <fieldset class="field-set">
        <legend>{t('raster.cells')}</legend>
        <div class="field-row">
          <CellsField {...props} />
        </div>
        <CellsHint {...props} />
      </fieldset>
    </>
  )
}

/** MovingAI's format says that swamp is passable, not what it costs. */
export function SwampFields({ choices, onChange }: Pick<FieldsProps, 'choices' | 'onChange'>) {
  const set = (swampFactor: number) => onChange({ swampFactor })
  const label = t('mapFile.swampFactor', { most: numbers.value.whole.format(MOST_FACTOR) })
  return (
    <fieldset class="field-set">
      <legend>{t('mapFile.swamp')}</legend>
      <div class="field-row">
        <NumberField
          label={label}
          value={choices.swampFactor}
          min={PLAIN}
          max={MOST_FACTOR}
          testId="map-swamp"
          onChange={set}
          onType={useRested(set)}
        />
      </div>
      <p class="hint">{t('mapFile.swampHint')}</p>
    </fieldset>
  )
}

/** A costmap holds more than free and occupied cells. */
function CostsFields({ choices, onChange }: Pick<FieldsProps, 'choices' | 'onChange'>) {
  const { costs, multiplier } = choices
  const setMultiplier = (value: number) => onChange({ multiplier: value })
  const typeMultiplier = useRested(setMultiplier)
  return (
    <fieldset class="field-set">
      <legend>{t('mapFile.costs')}</legend>
      <div class="field-row">
        <Segmented
          label={t('mapFile.costs')}
          value={costs ?? 'off'}
          options={(['off', 'nav2-smac-2d', 'nav2-navfn'] as const).map((rule) => ({
            value: rule,
            label: t(`mapFile.costRules.${rule}`),
            testId: `map-costs-${rule}`,
          }))}
          onChange={(rule) => onChange({ costs: rule === 'off' ? null : rule })}
        />
        {costs === 'nav2-smac-2d' && (
          <NumberField
            label={t('mapFile.multiplier')}
            value={multiplier}
            min={0}
            max={500}
            testId="map-multiplier"
            onChange={setMultiplier}
            onType={typeMultiplier}
          />
        )}
      </div>
      <p class="hint">{t(costs ? 'mapFile.costsHint' : 'mapFile.noCostsHint')}</p>
    </fieldset>
  )
}

function CellsField({
  choices,
  fits,
  whole,
  onChange,
  longer,
}: FieldsProps & { longer?: boolean }) {
  const most = longest(choices.crop ?? whole ?? { width: 0, height: 0 })
  const set = (cells: number) => onChange({ cells: cells === most ? null : cells })
  const onType = useRested(set)
  if (!whole) return null
  return (
    <NumberField
      label={t(longer ? 'mapFile.longerSide' : 'raster.presets')}
      value={choices.cells ?? most}
      min={1}
      max={most}
      step={1}
      invalid={!fits.cells}
      testId="map-cells"
      onChange={set}
      onType={onType}
    />
  )
}

function CellsHint({ choices, whole, fits }: Omit<FieldsProps, 'onChange'>) {
  const most = longest(choices.crop ?? whole ?? { width: 0, height: 0 })
  if (!fits.cells)
    return (
      <p class="field-error" role="alert">
        {t('mapFile.cellsOutside', { most: numbers.value.whole.format(most) })}
      </p>
    )
  return (
    <p class="hint">
      {t('mapFile.worst')}
      {(choices.cells ?? most) > WATCHED_SIDE && ` ${t('raster.large')}`}
    </p>
  )
}

function PixelCrop({ choices, fits, whole, onChange }: FieldsProps & { whole: Sides }) {
  const take = (crop: Crop) => onChange(cropped(choices, crop, whole))
  return (
    <CropFields
      whole={whole}
      crop={choices.crop ?? wholeOf(whole)}
      fits={fits.crop}
      all={choices.crop === null}
      legend={t('mapFile.part')}
      outside="mapFile.cropOutside"
      testId="map-crop"
      onChange={take}
      onWhole={() => take(wholeOf(whole))}
    />
  )
}
