/** Asks how to open a raster of heights: which part of it, and in how many cells. */
import type { Survey } from '@pkg/formicarium'
import { useState } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { describeNotice } from '../i18n/errors'
import { limits } from '../model/facts'
import {
  type Crop,
  cellOf,
  cropFits,
  isSquare,
  isWhole,
  type Sampling,
  type Size,
  sizeFits,
  sizeOf,
  suggested,
  WATCHED_SIDE,
  wholeOf,
  withSide,
} from '../model/raster_part'
import { type TerrainFile, terrainFile } from '../state'
import { openTerrain } from '../state/open_files'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { NumberField, Segmented } from '../ui/fields'
import { FormError } from '../ui/form_error'
import { CropFields } from './crop_fields'
import { TerrainPreview } from './terrain_preview'

const PRESETS = ['full', '513', '256'] as const
type Preset = (typeof PRESETS)[number]
const MOST: Record<Preset, number | null> = { full: null, '513': WATCHED_SIDE, '256': 256 }

export function TerrainDialog({ file }: { file: TerrainFile }) {
  const { survey, name } = file
  const [crop, setCrop] = useState(() => wholeOf(survey))
  const [sampling, setSampling] = useState(() => suggested(survey))
  const [error, setError] = useState<unknown>(null)
  const [busy, setBusy] = useState(false)
  const size = sizeOf(crop, survey, sampling)
  const fits = cropFits(crop, survey) && sizeFits(size)
  const close = () => {
    terrainFile.value = null
  }
  const open = async () => {
    if (!fits || busy) return
    setBusy(true)
    setError(null)
    const resampled = size[0] !== crop.width || size[1] !== crop.height
    try {
      await openTerrain(file, {
        ...(!isWhole(crop, survey) && { crop }),
        ...(resampled && { size }),
      })
    } catch (thrown) {
      setError(thrown)
      setBusy(false)
    }
  }
  return (
    <Dialog
      title={t('raster.title', { name })}
      onClose={close}
      onEnter={open}
      testId="terrain-dialog"
      wide
      actions={
        <>
          <Button label={t('mapFile.cancel')} testId="terrain-cancel" onClick={close} />
          <Button
            label={t('raster.open', { width: shown(size[0]), height: shown(size[1]) })}
            tone="primary"
            testId="terrain-open"
            disabled={!fits}
            busy={busy}
            onClick={open}
          />
        </>
      }
    >
      <div class="raster">
        <TerrainPreview survey={survey} crop={crop} onCrop={setCrop} />
        <Facts survey={survey} />
      </div>
      {survey.warnings.map((warning) => (
        <p key={warning.kind} class="hint" data-testid="terrain-warning">
          {describeNotice(warning)}
        </p>
      ))}
      <CropFields
        whole={survey}
        crop={crop}
        fits={cropFits(crop, survey)}
        all={isWhole(crop, survey) && cropFits(crop, survey)}
        legend={t('raster.part')}
        hint={t('raster.cropHint')}
        outside="raster.cropOutside"
        testId="crop"
        onChange={setCrop}
        onWhole={() => setCrop(wholeOf(survey))}
      />
      <SizeFields
        survey={survey}
        crop={crop}
        size={size}
        sampling={sampling}
        onChange={setSampling}
      />
      {error !== null && <FormError error={error} />}
    </Dialog>
  )
}

function Facts({ survey }: { survey: Survey }) {
  const { width, height, cell, lowest, highest, missing, kind } = survey
  const share = missing / (width * height)
  const rows: [string, string, string][] = [
    ['kind', t('raster.format'), t(`raster.kinds.${kind as 'geotiff'}`)],
    ['size', t('raster.size'), `${shown(width)} × ${shown(height)}`],
    ['cell', t('raster.cell'), t('raster.metres', { x: fine(cell[0]), y: fine(cell[1]) })],
    ['heights', t('raster.heights'), t('raster.range', { low: fine(lowest), high: fine(highest) })],
    ['missing', t('raster.missing'), missing === 0 ? t('raster.none') : percent(share)],
  ]
  return (
    <dl class="raster-facts">
      {rows.map(([id, label, value]) => (
        <div key={id}>
          <dt>{label}</dt>
          <dd data-testid={`raster-${id}`}>{value}</dd>
        </div>
      ))}
    </dl>
  )
}

interface SizeFieldsProps {
  survey: Survey
  crop: Crop
  size: Size
  sampling: Sampling
  onChange: (sampling: Sampling) => void
}

function SizeFields({ survey, crop, size, sampling, onChange }: SizeFieldsProps) {
  const fit = 'size' in sampling ? null : sampling
  const { square } = sampling
  const own = (given: { width: number } | { height: number }) =>
    onChange({ size: withSide(size, given, square, crop, survey), square })
  const toggleSquare = () => {
    const shape = withSide(size, { width: size[0] }, !square, crop, survey)
    onChange({ ...(fit ? { most: fit.most } : { size: shape }), square: !square })
  }
  const [x, y] = cellOf(crop, survey, size)
  // A side has whole cells, so square ones may differ by half a cell in all of them.
  const areSquare = square || isSquare([x, y])
  const preset = PRESETS.find((id) => fit && MOST[id] === fit.most)
  return (
    <fieldset class="field-set">
      <legend>{t('raster.cells')}</legend>
      <div class="field-row">
        <NumberField
          label={t('maps.width')}
          value={size[0]}
          min={2}
          max={limits.max_side}
          step={1}
          invalid={!sizeFits(size)}
          testId="size-width"
          onChange={(width) => own({ width })}
        />
        <NumberField
          label={t('maps.height')}
          value={size[1]}
          min={2}
          max={limits.max_side}
          step={1}
          invalid={!sizeFits(size)}
          testId="size-height"
          onChange={(height) => own({ height })}
        />
        <Segmented
          label={t('raster.presets')}
          value={preset ?? 'own'}
          options={PRESETS.map((id) => ({
            value: id as Preset | 'own',
            label: id === 'full' ? t('raster.full') : `≤ ${id}`,
            testId: `size-${id}`,
          }))}
          onChange={(id) => onChange({ most: id === 'own' ? null : MOST[id], square })}
        />
        <Button
          label={t('raster.square')}
          tone={square ? 'primary' : 'plain'}
          pressed={square}
          testId="size-square"
          onClick={toggleSquare}
        />
      </div>
      <p class="hint" data-testid="raster-result">
        {areSquare
          ? t('raster.resultSquare', { x: fine(x), y: fine(y) })
          : t('raster.result', { x: fine(x), y: fine(y), mean: fine(Math.sqrt(x * y)) })}
        {Math.max(...size) > WATCHED_SIDE && ` ${t('raster.large')}`}
      </p>
    </fieldset>
  )
}

const shown = (value: number) => numbers.value.whole.format(value)
const fine = (value: number) => numbers.value.metres.format(value)
const percent = (value: number) => numbers.value.share.format(value)
