import type { Generator } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { Dices } from 'lucide'
import { useState } from 'preact/hooks'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { generators, limits } from '../model/facts'
import type { Scenario } from '../model/session'
import { notifyError } from '../state'
import { closeDialog } from '../state/dialogs'
import { type GeneratorCall, generatedMap, openGenerated } from '../state/generated_maps'
import { Button, IconButton } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { NumberField, Segmented } from '../ui/fields'
import { FormError } from '../ui/form_error'
import { type Latest, useLatest } from './latest_answer'
import { MapPreview } from './map_preview'

/** Sides of terrains that papers and programs like. */
const SIDES = ['21', '65', '129', '257', '513']

/** Larger maps are not drawn before they are made: that would take longer than it is worth. Cells. */
const MOST_SHOWN = 1 << 20

/** Kept while the page lives, so that a second map starts from the first one's settings. */
const settings = signal({
  kind: 'random' as Generator,
  width: 40,
  height: 30,
  seed: 1,
  density: 30,
  roughness: 50,
})

export function GenerateDialog() {
  const [error, setError] = useState<unknown>(null)
  const [making, setMaking] = useState(false)
  const { kind, width, height, seed, density, roughness } = settings.value
  const { terrain: isTerrain = false, asks_for: asked = null } =
    generators.find(({ id }) => id === kind) ?? {}
  const most = 100 * limits.max_density
  const set = (change: Partial<typeof settings.value>) => {
    settings.value = { ...settings.value, ...change }
  }
  const call: GeneratorCall = {
    kind,
    width,
    height,
    seed,
    density: (asked === 'roughness' ? roughness : density) / 100,
  }
  const small = width * height <= MOST_SHOWN
  const preview = useLatest(JSON.stringify(call), small ? () => generatedMap(call) : null)
  const make = async () => {
    setMaking(true)
    try {
      const made = small && preview.settled ? preview.answer : await generatedMap(call)
      if (made) openGenerated(made)
      closeDialog()
    } catch (thrown) {
      setError(thrown)
      setMaking(false)
    }
  }
  return (
    <Dialog
      title={t('maps.titles.generate')}
      onClose={closeDialog}
      testId="generate-dialog"
      actions={
        <Button
          icon={Dices}
          label={t('maps.generateNow')}
          tone="primary"
          testId="generate"
          busy={making}
          onClick={make}
        />
      }
    >
      <Segmented
        label={t('maps.kindLabel')}
        value={kind}
        options={generators.map(({ id }) => ({
          value: id,
          label: t(`maps.kind.${id}`),
          testId: `generate-${id}`,
        }))}
        onChange={(id) => set({ kind: id })}
      />
      <div class="field-row">
        <SizeField name="width" value={width} onChange={(value) => set({ width: value })} />
        <SizeField name="height" value={height} onChange={(value) => set({ height: value })} />
        {asked === 'density' && (
          <NumberField
            label={t('maps.density')}
            value={density}
            min={0}
            max={most}
            testId="generate-density"
            onChange={(value) => set({ density: value })}
          />
        )}
        {asked === 'roughness' && (
          <NumberField
            label={t('maps.roughness')}
            value={roughness}
            min={0}
            max={most}
            testId="generate-roughness"
            onChange={(value) => set({ roughness: value })}
          />
        )}
        <span class="seed-field">
          <NumberField
            label={t('run.seed')}
            value={seed}
            min={0}
            max={0xffffffff}
            step={1}
            testId="generate-seed"
            onChange={(value) => set({ seed: value })}
          />
          <IconButton
            icon={Dices}
            label={t('run.newSeed')}
            onClick={() => tools.proposeSeed().then((value) => set({ seed: value }), notifyError)}
          />
        </span>
      </div>
      {isTerrain && (
        <Segmented
          label={t('maps.sides')}
          value={width === height ? String(width) : ''}
          options={SIDES.map((side) => ({
            value: side,
            label: `${side} × ${side}`,
            testId: `generate-side-${side}`,
          }))}
          onChange={(side) => set({ width: Number(side), height: Number(side) })}
        />
      )}
      <p class="hint">{t(isTerrain ? 'maps.generateTerrainHint' : 'maps.generateHint')}</p>
      {(error ?? preview.error) !== null && <FormError error={error ?? preview.error} />}
      <GeneratedPreview preview={preview} small={small} />
    </Dialog>
  )
}

/** The map as it would be. Its place is as large for every map, so that no field moves while one chooses. */
function GeneratedPreview(props: { preview: Latest<Scenario | null>; small: boolean }) {
  const { answer, settled } = props.preview
  return (
    <div class="generated" data-testid="generated" data-settled={settled}>
      {props.small ? (
        <MapPreview map={answer} busy={!settled} ends />
      ) : (
        <p class="hint">{t('maps.generateLarge')}</p>
      )}
    </div>
  )
}

function SizeField(props: {
  name: 'width' | 'height'
  value: number
  onChange: (value: number) => void
}) {
  return (
    <NumberField
      label={t(`maps.${props.name}`)}
      value={props.value}
      min={2}
      max={limits.max_side}
      step={1}
      testId={`generate-${props.name}`}
      onChange={props.onChange}
    />
  )
}
