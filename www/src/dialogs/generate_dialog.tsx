import { signal } from '@preact/signals'
import { Dices } from 'lucide'
import { useState } from 'preact/hooks'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { MOST_CELLS_A_SIDE } from '../model/map_limits'
import type { Origin } from '../model/session'
import { generateMap, notifyError } from '../state'
import { closeDialog } from '../state/dialogs'
import { Button, IconButton } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { NumberField, Segmented } from '../ui/fields'
import { FormError } from '../ui/form_error'

const KINDS: Origin['generator'][] = ['random', 'maze', 'rooms', 'cave', 'hills', 'fractal']
const TERRAINS: Origin['generator'][] = ['hills', 'fractal']
/** Sides of terrains that papers and programs like. */
const SIDES = ['21', '65', '129', '257', '513']

/** Kept while the page lives, so that a second map starts from the first one's settings. */
const settings = signal({
  kind: 'random' as Origin['generator'],
  width: 40,
  height: 30,
  seed: 1,
  density: 30,
  roughness: 50,
})

export function GenerateDialog() {
  const [error, setError] = useState<unknown>(null)
  const { kind, width, height, seed, density, roughness } = settings.value
  const isTerrain = TERRAINS.includes(kind)
  const set = (change: Partial<typeof settings.value>) => {
    settings.value = { ...settings.value, ...change }
  }
  const make = async () => {
    try {
      await generateMap(kind, width, height, seed, (isTerrain ? roughness : density) / 100)
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
        options={KINDS.map((id) => ({
          value: id,
          label: t(`maps.kind.${id}`),
          testId: `generate-${id}`,
        }))}
        onChange={(id) => set({ kind: id })}
      />
      <div class="field-row">
        <SizeField name="width" value={width} onChange={(value) => set({ width: value })} />
        <SizeField name="height" value={height} onChange={(value) => set({ height: value })} />
        {kind === 'random' && (
          <NumberField
            label={t('maps.density')}
            value={density}
            min={0}
            max={90}
            testId="generate-density"
            onChange={(value) => set({ density: value })}
          />
        )}
        {isTerrain && (
          <NumberField
            label={t('maps.roughness')}
            value={roughness}
            min={0}
            max={90}
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
      max={MOST_CELLS_A_SIDE}
      step={1}
      testId={`generate-${props.name}`}
      onChange={props.onChange}
    />
  )
}
