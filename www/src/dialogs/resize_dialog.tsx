import { useState } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { limits } from '../model/facts'
import { scenario } from '../state'
import { closeDialog } from '../state/dialogs'
import { type Rules, setRules } from '../state/movement_rules'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { NumberField, Select } from '../ui/fields'
import { lazily } from '../ui/lazily'
import { MOVEMENTS, movementId, toMovement } from '../words/movement_words'
import { ModelField, SliceFields, SurfaceFields, terrainFits } from './terrain_fields'

const RobotFields = lazily(async () => (await import('./robot_fields')).fetchRobotFields())

/** Size of the map and the moves allowed on it; on a terrain, all rules of moving. */
export function ResizeDialog() {
  const now = scenario.value
  const [rules, setAll] = useState<Rules | null>(() => now && rulesOf(now.spec))
  const [placeless, setPlaceless] = useState(false)
  if (!now || !rules) return null
  const { width, height, movement, terrain } = rules
  const set = (change: Partial<Rules>) => {
    setPlaceless(false)
    setAll({ ...rules, ends: undefined, ...change })
  }
  const sizeFits = [width, height].every(
    (n) => Number.isInteger(n) && n >= 2 && n <= limits.max_side,
  )
  const fits =
    sizeFits &&
    rules.resolution > 0 &&
    rules.resolution <= 1e6 &&
    (!terrain || terrainFits(terrain))
  const apply = () => {
    if (!fits) return
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
        <Scale rules={rules} onChange={set} />
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
      <RobotFields scenario={now} rules={rules} onChange={set} />
      {placeless && (
        <p class="field-error" role="alert" data-testid="no-place">
          {t('terrain.noPlace')}
        </p>
      )}
    </Dialog>
  )
}

function rulesOf({ width, height, movement, resolution, terrain, robot }: Rules): Rules {
  return { width, height, movement, resolution, robot, ...(terrain && { terrain }) }
}

/** How long a cell and a unit of height are. Not shown on a plane, where only tables would use it. */
function Scale({ rules, onChange }: { rules: Rules; onChange: (change: Partial<Rules>) => void }) {
  const { resolution, terrain } = rules
  if (!terrain) return null
  return (
    <>
      <NumberField
        label={t('terrain.resolution')}
        value={Number(resolution.toPrecision(6))}
        min={0}
        max={1e6}
        invalid={!(resolution > 0)}
        live
        testId="resolution"
        onChange={(value) => onChange({ resolution: value })}
      />
      <NumberField
        label={t('terrain.verticalUnit')}
        value={terrain.vertical_unit}
        min={0}
        max={1e6}
        invalid={!(terrain.vertical_unit > 0)}
        live
        testId="vertical-unit"
        onChange={(vertical_unit) => onChange({ terrain: { ...terrain, vertical_unit } })}
      />
    </>
  )
}
