import type { Generator } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { Dices } from 'lucide'
import { useState } from 'preact/hooks'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { generators, limits } from '../model/facts'
import { notifyError } from '../state'
import { closeDialog } from '../state/dialogs'
import { generateMap } from '../state/generate_map'
import { Button, IconButton } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { NumberField, Segmented } from '../ui/fields'
import { FormError } from '../ui/form_error'

/** Sides of terrains that papers and programs like. */
const SIDES = ['21', '65', '129', '257', '513']

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
  const { kind, width, height, seed, density, roughness } = settings.value
  const { terrain: isTerrain = false, asks_for: asked = null } =
    generators.find(({ id }) => id === kind) ?? {}
  const most = 100 * limits.max_density
  const set = (change: Partial<typeof settings.value>) => {
    settings.value = { ...settings.value, ...change }
  }
  const make = async () => {
    try {
      await generateMap(
        kind,
        width,
        height,
        seed,
        (asked === 'roughness' ? roughness : density) / 100,
      )
      closeDialog()
    } catch (thrown) {
      setError(thrown)
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
      {error !== null && <FormError error={error} />}
    </Dialog>
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
