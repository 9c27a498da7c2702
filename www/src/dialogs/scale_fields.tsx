/** How large cells are, how fast one moves, and in which unit lengths are read: a group of “Size, moves and robot”. */
import type { ScenarioSpec } from '@pkg/formicarium'
import { useId } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { scaleOf } from '../model/world'
import type { LengthUnit } from '../state/length_unit'
import type { Rules } from '../state/movement_rules'
import { Labelled, NumberField, Segmented } from '../ui/fields'
import { distanceWords } from '../words/metres'
import type { Quantity, WrongQuantity } from './quantities'
import { checkedBy, Wrong } from './wrong_field'

/** What is wrong with anything that has no field is said here, too. */
const OF_SCALE = ['resolution', 'speed', 'seconds_per_turn', null] as const
/** Digits of what an import has computed. */
const DIGITS = 6

interface ScaleFieldsProps {
  spec: ScenarioSpec
  rules: Rules
  unit: LengthUnit
  wrong: WrongQuantity | null
  onChange: (change: Partial<Rules>) => void
  onUnit: (unit: LengthUnit) => void
}

export function ScaleFields({ spec, rules, unit, wrong, onChange, onUnit }: ScaleFieldsProps) {
  const id = useId()
  const { resolution, vehicle, terrain } = rules
  const checked = (field: Quantity) => ({
    min: 0,
    max: 1e6,
    live: true,
    ...checkedBy(field, wrong, id),
  })
  return (
    <fieldset class="rule-group">
      <legend>{t('scale.title')}</legend>
      <div class="field-row">
        <NumberField
          label={t('scale.cell')}
          value={Number(resolution.toPrecision(DIGITS))}
          testId="resolution"
          onChange={(value) => onChange({ resolution: value })}
          {...checked('resolution')}
        />
        {terrain && (
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
        )}
        <NumberField
          label={t('scale.speed')}
          value={vehicle.speed}
          testId="speed-metres"
          onChange={(speed) => onChange({ vehicle: { ...vehicle, speed } })}
          {...checked('speed')}
        />
        <NumberField
          label={t('scale.turn')}
          value={vehicle.seconds_per_turn}
          testId="turn-seconds"
          onChange={(turn) => onChange({ vehicle: { ...vehicle, seconds_per_turn: turn } })}
          {...checked('seconds_per_turn')}
        />
      </div>
      <Wrong wrong={wrong} of={OF_SCALE} id={id} testId="quantity-wrong" />
      <p class="hint">{`${wholeWords(rules)} ${t('scale.time')}`}</p>
      <UnitField spec={spec} rules={rules} unit={unit} onUnit={onUnit} />
    </fieldset>
  )
}

function wholeWords({ width, height, resolution }: Rules): string {
  const sides = [width * resolution, height * resolution]
  if (!sides.every((side) => side > 0 && Number.isFinite(side))) return ''
  const [x, y] = sides.map(distanceWords)
  return t('scale.whole', { x, y })
}

type UnitFieldProps = Pick<ScaleFieldsProps, 'spec' | 'rules' | 'unit' | 'onUnit'>

/** Where there is no choice it says why. */
function UnitField({ spec, rules, unit, onUnit }: UnitFieldProps) {
  const { resolution, terrain } = rules
  if (terrain?.slices) return <p class="hint">{t('scale.slices')}</p>
  if (scaleOf({ ...spec, resolution }) === null)
    return (
      <p class="hint" data-testid="no-scale">
        {t('scale.none')}
      </p>
    )
  return (
    <Labelled label={t('scale.unit')}>
      <Segmented
        label={t('scale.unit')}
        value={unit}
        options={(['metres', 'cells'] as const).map((value) => ({
          value,
          label: t(`scale.units.${value}`),
          testId: `lengths-${value}`,
        }))}
        onChange={onUnit}
      />
    </Labelled>
  )
}
