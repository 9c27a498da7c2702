/** The robot in "Size, moves and robot": how much room it needs, and what cells near obstacles cost it. */
import '../styles/raster.css'
import type { CostRule, Inflation, Robot } from '@pkg/formicarium'
import { useId } from 'preact/hooks'
import { lateTools } from '../engine/late_tools'
import { addWeightWords, t } from '../i18n/weights'
import { endsWithRoom, fittingRadius, withoutRoom } from '../model/robot_room'
import type { Scenario } from '../model/session'
import type { FeltCells } from '../model/tool_calls'
import { type Rules, underRules } from '../state/movement_rules'
import { Button } from '../ui/buttons'
import { NumberField, Segmented } from '../ui/fields'
import { FormError } from '../ui/form_error'
import { useLatest } from './latest_answer'
import { isOfRobot, type RobotQuantity, type WrongQuantity } from './quantities'
import { checkedBy, Wrong } from './wrong_field'

/** Nav2's `robot_radius`, in metres; a map of larger cells begins with one of them. */
const NAV2_RADIUS = 0.1
/** Nav2's `inflation_radius`, `cost_scaling_factor` and `cost_travel_multiplier`. */
const NAV2: Required<Omit<Inflation, 'rule'>> = { radius: 0.55, cost_scaling: 10, multiplier: 2 }
const RULES = ['off', 'nav2-smac-2d', 'nav2-navfn'] as const
const OF_INFLATION = [
  'robot.inflation.radius',
  'robot.inflation.cost_scaling',
  'robot.inflation.multiplier',
] as const satisfies RobotQuantity[]

export const fetchRobotFields = () => addWeightWords().then(() => RobotFields)

interface RobotFieldsProps {
  scenario: Scenario
  rules: Rules
  wrong: WrongQuantity | null
  onChange: (change: Partial<Rules>) => void
}

export function RobotFields({ scenario, rules, wrong, onChange }: RobotFieldsProps) {
  const { robot } = rules
  const group = {
    robot,
    resolution: rules.resolution,
    wrong,
    onChange: (next: Robot | undefined) => onChange({ robot: next }),
  }
  return (
    <>
      <fieldset class="field-set" data-testid="robot-fields">
        <legend>{t('weights.robot')}</legend>
        <SizeFields {...group} />
      </fieldset>
      {/* What a step costs on a terrain is not defined: there they can only be taken away. */}
      {(!rules.terrain || robot?.inflation) && (
        <fieldset class="field-set">
          <legend>{t('weights.cost')}</legend>
          <InflationFields {...group} />
        </fieldset>
      )}
      {robot && !(wrong && isOfRobot(wrong.field)) && (
        <Room scenario={scenario} rules={rules} onChange={onChange} />
      )}
    </>
  )
}

interface GroupProps {
  robot: Robot | undefined
  /** Metres a cell. */
  resolution: number
  wrong: WrongQuantity | null
  onChange: (robot: Robot | undefined) => void
}

function SizeFields({ robot, resolution, wrong, onChange }: GroupProps) {
  const id = useId()
  const size = robot && robot.radius !== 0 ? 'round' : 'point'
  const setRadius = (radius: number) => onChange(lean({ ...robot, radius }))
  return (
    <>
      <div class="field-row">
        <Segmented
          label={t('weights.robot')}
          value={size}
          options={(['point', 'round'] as const).map((value) => ({
            value,
            label: t(`weights.sizes.${value}`),
            testId: `robot-${value}`,
          }))}
          onChange={(value) => {
            if (value !== size) setRadius(value === 'point' ? 0 : Math.max(NAV2_RADIUS, resolution))
          }}
        />
        {robot && size === 'round' && (
          <NumberField
            label={t('weights.radius')}
            value={robot.radius}
            min={0}
            max={1e6}
            live
            testId="robot-radius"
            onChange={setRadius}
            {...checkedBy('robot.radius', wrong, id)}
          />
        )}
      </div>
      <Wrong wrong={wrong} of={['robot.radius']} id={id} testId="robot-wrong" />
      {wrong?.field !== 'robot.radius' && (
        <p class="hint">
          {robot && size === 'round'
            ? radiusHint(robot.radius / resolution)
            : t('weights.pointHint')}
        </p>
      )}
    </>
  )
}

function InflationFields({ robot, resolution, wrong, onChange }: GroupProps) {
  const id = useId()
  const inflation = robot?.inflation
  const rule = inflation?.rule ?? 'off'
  const set = (next: Inflation | undefined) =>
    onChange(lean({ radius: robot?.radius ?? 0, ...(next && { inflation: next }) }))
  return (
    <>
      <div class="field-row">
        <Segmented
          label={t('weights.cost')}
          value={rule}
          options={RULES.map((value) => ({
            value,
            label: t(`weights.rules.${value}`),
            testId: `inflation-${value}`,
          }))}
          onChange={(value) => set(value === 'off' ? undefined : withRule(inflation, value))}
        />
      </div>
      {inflation && <CostFields inflation={inflation} wrong={wrong} id={id} onChange={set} />}
      <Wrong wrong={wrong} of={OF_INFLATION} id={id} testId="robot-wrong" />
      <p class="hint">
        {t(`weights.ruleHints.${rule}`)}
        {inflation && inflation.radius <= resolution && (
          <> {t('weights.noEffect', { resolution: fine(resolution) })}</>
        )}
      </p>
    </>
  )
}

interface CostProps {
  inflation: Inflation
  wrong: WrongQuantity | null
  id: string
  onChange: (inflation: Inflation) => void
}

function CostFields({ inflation, wrong, id, onChange }: CostProps) {
  const field = (key: 'radius' | 'cost_scaling' | 'multiplier', label: string, max: number) => (
    <NumberField
      label={label}
      value={inflation[key] ?? NAV2[key]}
      min={0}
      max={max}
      live
      testId={`inflation-${key}`}
      onChange={(value) => onChange({ ...inflation, [key]: value })}
      {...checkedBy(`robot.inflation.${key}`, wrong, id)}
    />
  )
  return (
    <div class="field-row">
      {field('radius', t('weights.inflationRadius'), 1e6)}
      {field('cost_scaling', t('weights.scaling'), 1000)}
      {inflation.rule === 'nav2-smac-2d' && field('multiplier', t('weights.multiplier'), 500)}
    </div>
  )
}

/** What the engine says of it, and whether the robot has room at start and goals. */
function Room({ scenario, rules, onChange }: Omit<RobotFieldsProps, 'wrong'>) {
  const map = underRules(scenario, rules)
  const asked = map && !Object.values(numbersOf(rules)).some(Number.isNaN)
  const { answer, error, settled } = useLatest<FeltCells>(
    JSON.stringify(rules),
    asked ? () => lateTools.feltMap(map) : null,
  )
  if (error !== null) return <FormError error={error} />
  const narrow = answer && settled && map ? withoutRoom(map.spec, answer) : null
  if (rules.ends) return <p class="hint">{t('weights.willMove')}</p>
  if (!narrow || !answer || !map) return null
  const ends = endsWithRoom(map.spec, answer)
  const radius = fittingRadius(map)
  return (
    <div class="no-room" role="alert" data-testid="robot-no-room">
      <p class="field-error">{t(`weights.noRoom.${narrow}`)}</p>
      <div class="button-row">
        <Button
          label={t('weights.smaller', { radius: fine(radius) })}
          testId="robot-smaller"
          onClick={() => onChange({ robot: lean({ ...rules.robot, radius }) })}
        />
        {ends ? (
          <Button
            label={t('weights.move')}
            testId="robot-move"
            onClick={() => onChange({ ends })}
          />
        ) : (
          <span>{t('weights.nowhere')}</span>
        )}
      </div>
    </div>
  )
}

/** All that is typed of a robot. */
const numbersOf = ({ robot }: Rules): Record<string, number> => {
  const { rule: _, ...inflation } = robot?.inflation ?? { rule: null }
  return { own: robot?.radius ?? 0, ...inflation }
}

/** None where it is a point that obstacles do not matter to. */
const lean = (robot: Robot): Robot | undefined =>
  robot.radius === 0 && !robot.inflation ? undefined : robot

const withRule = (before: Inflation | undefined, rule: CostRule): Inflation => ({
  ...NAV2,
  ...before,
  rule,
})

/** It counts what it tells: 1.00001 cells are told as one. */
function radiusHint(cells: number): string {
  const radius = fine(cells)
  return t('weights.radiusHint', { radius, count: Number(radius) })
}

/** A radius is told to the millimetre. */
const fine = (value: number) => String(Number(value.toPrecision(4)))
