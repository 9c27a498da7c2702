import { useState } from 'preact/hooks'
import { t } from '../i18n'
import { resizeMap, scenario, setMovement } from '../state'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { closeDialog } from '../ui/dialogs'
import { NumberField, Select } from '../ui/fields'
import { MOST_CELLS_A_SIDE } from './limits'
import { MOVEMENTS, type MovementId, movementId, toMovement } from './movement'

/** Size of the map and the moves allowed on it. */
export function ResizeDialog() {
  const spec = scenario.value?.spec
  const [width, setWidth] = useState(spec?.width ?? 2)
  const [height, setHeight] = useState(spec?.height ?? 2)
  const [movement, choose] = useState<MovementId>(spec ? movementId(spec.movement) : '8-both-free')
  if (!spec) return null
  const fits = [width, height].every((n) => Number.isInteger(n) && n >= 2 && n <= MOST_CELLS_A_SIDE)
  const apply = () => {
    if (width !== spec.width || height !== spec.height) resizeMap(width, height)
    if (movement !== movementId(spec.movement)) setMovement(toMovement(movement))
    closeDialog()
  }
  return (
    <Dialog
      title={t('maps.titles.shape')}
      onClose={closeDialog}
      testId="resize-dialog"
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
        <NumberField
          label={t('maps.width')}
          value={width}
          min={2}
          max={MOST_CELLS_A_SIDE}
          step={1}
          invalid={!fits}
          testId="resize-width"
          onChange={setWidth}
        />
        <NumberField
          label={t('maps.height')}
          value={height}
          min={2}
          max={MOST_CELLS_A_SIDE}
          step={1}
          invalid={!fits}
          testId="resize-height"
          onChange={setHeight}
        />
      </div>
      <p class="hint">{t('maps.resizeHint', { most: MOST_CELLS_A_SIDE })}</p>
      <Select
        label={t('movement.label')}
        value={movement}
        testId="movement"
        options={MOVEMENTS.map((id) => ({ value: id, label: t(`movement.${id}`) }))}
        onChange={choose}
      />
      <p class="hint">{t(`movement.notes.${movement}`)}</p>
    </Dialog>
  )
}
