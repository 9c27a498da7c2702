/** How a path is to drive, in "Size, moves and robot": a smooth curve over it, and what driving costs. */
import '../styles/raster.css'
import type { EnergyRule, Vehicle } from '@pkg/formicarium'
import { useId } from 'preact/hooks'
import { tools } from '../engine/tools'
import { numbers } from '../i18n'
import { addDrivingWords, t } from '../i18n/driving'
import type { Rules } from '../state/movement_rules'
import { NumberField, Segmented } from '../ui/fields'
import { DRIVING_LABELS, type WrongQuantity } from './quantities'
import { checkedBy, Wrong } from './wrong_field'

const MODES = ['off', 'on'] as const
/** Digits of a radius that was told as a curvature. */
const DIGITS = 6

interface DrivingFieldsProps {
  rules: Rules
  wrong: WrongQuantity | null
  onChange: (change: Partial<Rules>) => void
}

/** With the words, and with the coefficients that the engine takes where a map says nothing. */
export async function fetchDrivingFields() {
  const [usual] = await Promise.all([usualEnergy(), addDrivingWords()])
  return (props: DrivingFieldsProps) => <DrivingFields {...props} usual={usual} />
}

/** What the engine's reader writes where a scenario leaves the coefficients out. */
async function usualEnergy(): Promise<EnergyRule | undefined> {
  const scenario = {
    format: 'formicarium/scenario@1',
    width: 2,
    height: 1,
    start: [0, 0],
    goals: [{ at: [1, 0] }],
    vehicle: { speed: 1, seconds_per_turn: 0, energy: {} },
    map: { rows: ['..'] },
  }
  const bytes = new TextEncoder().encode(JSON.stringify(scenario))
  return (await tools.importMap(bytes, 'usual.json')).spec.vehicle.energy
}

function DrivingFields({
  rules: { vehicle },
  wrong,
  usual,
  onChange,
}: DrivingFieldsProps & { usual: EnergyRule | undefined }) {
  const set = ({ energy, smoothing, ...plain }: Vehicle) =>
    onChange({ vehicle: { ...plain, ...(energy && { energy }), ...(smoothing && { smoothing }) } })
  const group = { vehicle, wrong, onChange: set }
  return (
    <>
      <CurveFields {...group} />
      {usual && <EnergyFields {...group} usual={usual} />}
    </>
  )
}

interface GroupProps {
  vehicle: Vehicle
  wrong: WrongQuantity | null
  onChange: (vehicle: Vehicle) => void
}

function CurveFields({ vehicle, wrong, onChange }: GroupProps) {
  const id = useId()
  const { smoothing, ...others } = vehicle
  const curvature = smoothing?.max_curvature
  const setRadius = (radius: number) =>
    onChange({ ...vehicle, smoothing: { max_curvature: radius ? 1 / radius : 0 } })
  return (
    <fieldset class="field-set" data-testid="curve-fields">
      <legend>{t('driving.curve')}</legend>
      <div class="field-row">
        <Switch
          what="curve"
          on={smoothing !== undefined}
          onChange={(on) => (on ? setRadius(0) : onChange(others))}
        />
        {curvature !== undefined && (
          <NumberField
            label={t('driving.radius')}
            value={curvature === 0 ? 0 : Number((1 / curvature).toPrecision(DIGITS))}
            min={0}
            max={1e6}
            live
            testId="turning-radius"
            onChange={setRadius}
            {...checkedBy('max_curvature', wrong, id)}
          />
        )}
      </div>
      <Wrong wrong={wrong} of={['max_curvature']} id={id} testId="driving-wrong" />
      <p class="hint">{t(`driving.curveHints.${smoothing ? 'on' : 'off'}`)}</p>
    </fieldset>
  )
}

const COEFFICIENTS = ['per_metre', 'per_radian', 'per_metre_up'] as const

function EnergyFields({ vehicle, wrong, usual, onChange }: GroupProps & { usual: EnergyRule }) {
  const id = useId()
  const { energy, ...others } = vehicle
  const usually = {
    metre: plain(usual.per_metre),
    radian: plain(usual.per_radian),
    up: plain(usual.per_metre_up),
  }
  return (
    <fieldset class="field-set" data-testid="energy-fields">
      <legend>{t('driving.energy')}</legend>
      <div class="field-row">
        <Switch
          what="energy"
          on={energy !== undefined}
          onChange={(on) => onChange(on ? { ...others, energy: usual } : others)}
        />
      </div>
      {energy && (
        <div class="field-row">
          {COEFFICIENTS.map((key) => (
            <NumberField
              key={key}
              label={t(DRIVING_LABELS[key])}
              value={energy[key]}
              min={0}
              max={1e9}
              live
              testId={`energy-${key}`}
              onChange={(value) => onChange({ ...others, energy: { ...energy, [key]: value } })}
              {...checkedBy(key, wrong, id)}
            />
          ))}
        </div>
      )}
      <Wrong wrong={wrong} of={COEFFICIENTS} id={id} testId="driving-wrong" />
      <p class="hint">{t(`driving.energyHints.${energy ? 'on' : 'off'}`, usually)}</p>
    </fieldset>
  )
}

interface SwitchProps {
  what: 'curve' | 'energy'
  on: boolean
  onChange: (on: boolean) => void
}

function Switch({ what, on, onChange }: SwitchProps) {
  return (
    <Segmented
      label={t(`driving.${what}`)}
      value={on ? 'on' : 'off'}
      options={MODES.map((value) => ({
        value,
        label: t(`driving.${value}`),
        testId: `${what}-${value}`,
      }))}
      onChange={(value) => {
        if ((value === 'on') !== on) onChange(value === 'on')
      }}
    />
  )
}

const plain = (value: number) => numbers.peek().metres.format(value)
