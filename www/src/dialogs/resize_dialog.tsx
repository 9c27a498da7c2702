import { useState } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { limits } from '../model/facts'
import type { Scenario } from '../model/session'
import { scenario } from '../state'
import { closeDialog } from '../state/dialogs'
import { lengthUnit, setLengthUnit } from '../state/length_unit'
import { type Rules, setRules } from '../state/movement_rules'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { NumberField, Select } from '../ui/fields'
import { lazily } from '../ui/lazily'
import { MOVEMENTS, movementId, toMovement } from '../words/movement_words'
import { useWrongQuantity, wrongQuantity } from './quantities'
import { ScaleFields } from './scale_fields'
import { ModelField, SliceFields, SurfaceFields, terrainFits } from './terrain_fields'

const DrivingFields = lazily(async () => (await import('./driving_fields')).fetchDrivingFields())
const RobotFields = lazily(async () => (await import('./robot_fields')).fetchRobotFields())

/** Size of the map, the moves allowed on it and who makes them; on a terrain, all rules of moving. */
export function ResizeDialog() {
  return scenario.value && <Form now={scenario.value} />
}

function Form({ now }: { now: Scenario }) {
  const [rules, setAll] = useState<Rules>(() => rulesOf(now.spec))
  const [unit, setUnit] = useState(lengthUnit.value)
  const [placeless, setPlaceless] = useState(false)
  const wrong = useWrongQuantity(now.spec, rules)
  const { width, height, movement, terrain } = rules
  const set = (change: Partial<Rules>) => {
    setPlaceless(false)
    setAll({ ...rules, ends: undefined, ...change })
  }
  const sizeFits = [width, height].every(
    (n) => Number.isInteger(n) && n >= 2 && n <= limits.max_side,
  )
  const fits = sizeFits && !wrong && (!terrain || terrainFits(terrain))
  const apply = async () => {
    // What was typed last may not have been looked at.
    if (!fits || (await wrongQuantity(now.spec, rules))) return
    setLengthUnit(unit)
    if (setRules(rules)) closeDialog()
    else setPlaceless(true)
  }
  return (
    <Dialog
      title={t(terrain ? 'maps.titles.shapeTerrain' : 'maps.titles.shape')}
      onClose={closeDialog}
      testId="resize-dialog"
      onEnter={apply}
      live
      actions={
        <Button
          label={t('common.apply')}
          tone="primary"
          testId="resize"
          disabled={!fits}
          onClick={apply}
        />
      }
    >
      <div class="field-row">
        {(['width', 'height'] as const).map((side) => (
          <NumberField
            key={side}
            label={t(`maps.${side}`)}
            value={rules[side]}
            min={2}
            max={limits.max_side}
            step={1}
            invalid={!sizeFits}
            live
            testId={`resize-${side}`}
            onChange={(value) => set({ [side]: value })}
          />
        ))}
      </div>
      <p class="hint">
        {t(terrain ? 'maps.resizeTerrainHint' : 'maps.resizeHint', { most: limits.max_side })}
      </p>
      {terrain && (
        <ModelField
          terrain={terrain}
          scenario={now}
          onChange={(changed) => set({ terrain: changed })}
        />
      )}
      {terrain?.slices ? (
        <SliceFields
          rules={terrain.slices}
          onChange={(slices) => set({ terrain: { ...terrain, slices } })}
        />
      ) : (
        <>
          <Select
            label={t('movement.label')}
            value={movementId(movement)}
            testId="movement"
            options={MOVEMENTS.map((id) => ({ value: id, label: t(`movement.${id}`) }))}
            onChange={(id) => set({ movement: toMovement(id) })}
          />
          <p class="hint">{t(`movement.notes.${movementId(movement)}`)}</p>
          {terrain && (
            <SurfaceFields terrain={terrain} onChange={(changed) => set({ terrain: changed })} />
          )}
        </>
      )}
      <ScaleFields
        spec={now.spec}
        rules={rules}
        unit={unit}
        wrong={wrong}
        onChange={set}
        onUnit={setUnit}
      />
      <RobotFields scenario={now} rules={rules} wrong={wrong} onChange={set} />
      {!terrain?.slices && <DrivingFields rules={rules} wrong={wrong} onChange={set} />}
      {placeless && (
        <p class="field-error" role="alert" data-testid="no-place">
          {t('terrain.noPlace')}
        </p>
      )}
    </Dialog>
  )
}

function rulesOf({ width, height, movement, resolution, vehicle, terrain, robot }: Rules): Rules {
  return { width, height, movement, resolution, vehicle, robot, ...(terrain && { terrain }) }
}
