/** How the robot drives, and how far it sees. */
import type { ParamSpec } from '@pkg/formicarium'
import { t } from '../i18n/drive'
import { ParameterRows } from '../panels/parameter_rows'
import { mapIsFixed } from '../state/embedding'
import { NumberField, Segmented } from '../ui/fields'
import { driving, failure, rows } from './drive'
import { changeSight, movingNow } from './moving'

/** Cells, for who begins to limit it. */
const SIGHT = 5

export function Settings() {
  return (
    <details class="drive-settings" data-testid="drive-settings">
      <summary>{t('drive.settings')}</summary>
      <ParameterRows rows={rows.value.map(rowOf)} />
      {!mapIsFixed.value && <Sight />}
    </details>
  )
}

function rowOf(spec: ParamSpec) {
  const { key } = spec
  return {
    // Beside a planner's own iterations: those of each planning.
    spec: key === 'iterations' ? { ...spec, key: 'plan_iterations' } : spec,
    value: driving.value[key] ?? spec.default,
    base: spec.default,
    error: failure.value?.field === key ? failure.value : null,
    onChange: (value: ParamSpec['default']) => {
      const { [key]: _, ...others } = driving.peek()
      driving.value = value === spec.default ? others : { ...others, [key]: value }
    },
  }
}

function Sight() {
  const { sight } = movingNow()
  return (
    <div class="field-row drive-sight">
      <span class="field-label" aria-hidden="true">
        {t('drive.sight')}
      </span>
      <Segmented
        label={t('drive.sight')}
        value={sight == null ? 'all' : 'some'}
        options={[
          { value: 'all', label: t('drive.seesAll'), testId: 'sight-all' },
          { value: 'some', label: t('drive.seesSome'), testId: 'sight-some' },
        ]}
        onChange={(value) => void changeSight(value === 'all' ? null : SIGHT)}
      />
      {sight != null && (
        <NumberField
          label={t('drive.sightCells')}
          hideLabel
          value={sight}
          min={0}
          max={1000}
          testId="sight-cells"
          onChange={(value) => void changeSight(value)}
        />
      )}
    </div>
  )
}
