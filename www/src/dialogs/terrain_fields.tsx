/** How one moves on a terrain, as fields of a form: on its surface, or by slices above it. */
import type { SliceRules, TerrainFields } from '@pkg/formicarium'
import { useRef } from 'preact/hooks'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { limits } from '../model/facts'
import type { Scenario } from '../model/session'
import { notifyError } from '../state'
import { Labelled, NumberField, Segmented } from '../ui/fields'

interface ModelProps {
  terrain: TerrainFields
  /** Suggests the rules when slices are chosen. */
  scenario: Scenario
  onChange: (terrain: TerrainFields) => void
}

export function ModelField({ terrain, scenario, onChange }: ModelProps) {
  const { vertical_unit, slices } = terrain
  const model = slices ? 'slices' : 'surface'
  const latest = useRef(terrain)
  latest.current = terrain
  const goBySlices = async () => {
    const slices = await tools.fittingSlices(scenario, vertical_unit)
    // What has been changed meanwhile counts.
    if (latest.current === terrain) onChange({ vertical_unit, slices })
  }
  return (
    <>
      <Labelled label={t('terrain.model')}>
        <Segmented
          label={t('terrain.model')}
          value={model}
          options={(['surface', 'slices'] as const).map((value) => ({
            value,
            label: t(`terrain.models.${value}`),
            testId: `model-${value}`,
          }))}
          onChange={(value) => {
            if (value === model) return
            if (value === 'surface') onChange({ vertical_unit, max_slope: 90 })
            else goBySlices().catch(notifyError)
          }}
        />
      </Labelled>
      <p class="hint">{t(`terrain.notes.${model}`)}</p>
    </>
  )
}

interface FieldsProps {
  terrain: TerrainFields
  onChange: (terrain: TerrainFields) => void
}

export function SurfaceFields({ terrain, onChange }: FieldsProps) {
  const slope = terrain.max_slope ?? 90
  return (
    <div class="field-row">
      <NumberField
        label={t('terrain.maxSlope')}
        value={slope}
        min={0}
        max={90}
        invalid={!(slope > 0 && slope <= 90)}
        live
        testId="max-slope"
        onChange={(max_slope) => onChange({ ...terrain, max_slope })}
      />
    </div>
  )
}

type Whole = 'levels' | 'start_level' | 'goal_level' | 'max_aside' | 'max_climb'

export function SliceFields({
  rules,
  onChange,
}: {
  rules: SliceRules
  onChange: (rules: SliceRules) => void
}) {
  const ranges: Record<Whole, [least: number, most: number]> = {
    levels: [1, limits.max_levels],
    start_level: [1, rules.levels],
    goal_level: [1, rules.levels],
    max_aside: [0, limits.max_reach],
    max_climb: [0, limits.max_reach],
  }
  const whole = (key: Whole) => {
    const [min, max] = ranges[key]
    return (
      <NumberField
        key={key}
        label={t(`terrain.slices.${key}`)}
        value={rules[key]}
        min={min}
        max={max}
        step={1}
        invalid={!isWhole(rules[key], min, max)}
        live
        testId={`slices-${key}`}
        onChange={(value) => onChange({ ...rules, [key]: value })}
      />
    )
  }
  return (
    <>
      <div class="field-row">
        <NumberField
          label={t('terrain.slices.level')}
          value={rounded(rules.level)}
          min={0}
          max={1e6}
          invalid={!(rules.level > 0)}
          live
          testId="slices-level"
          onChange={(level) => onChange({ ...rules, level })}
        />
        {(['levels', 'start_level', 'goal_level'] as const).map(whole)}
      </div>
      <div class="field-row">{(['max_aside', 'max_climb'] as const).map(whole)}</div>
      <Labelled label={t('terrain.measure')}>
        <Segmented
          label={t('terrain.measure')}
          value={rules.measure}
          options={(['cost', 'length'] as const).map((value) => ({
            value,
            label: t(`terrain.measures.${value}`),
            testId: `measure-${value}`,
          }))}
          onChange={(measure) => onChange({ ...rules, measure })}
        />
      </Labelled>
      <p class="hint">{t(`terrain.measureNotes.${rules.measure}`)}</p>
    </>
  )
}

/** Whether the engine would take these rules: it must be known before the dialog closes. */
export function terrainFits({ vertical_unit, max_slope = 90, slices }: TerrainFields): boolean {
  if (!(vertical_unit > 0 && vertical_unit <= 1e6)) return false
  if (!slices) return max_slope > 0 && max_slope <= 90
  const { level, levels, start_level, goal_level, max_aside, max_climb } = slices
  return (
    level > 0 &&
    level <= 1e6 &&
    isWhole(levels, 1, limits.max_levels) &&
    [start_level, goal_level].every((n) => isWhole(n, 1, levels)) &&
    [max_aside, max_climb].every((n) => isWhole(n, 0, limits.max_reach))
  )
}

function isWhole(value: number, least: number, most: number): boolean {
  return Number.isInteger(value) && value >= least && value <= most
}

/** Precise enough for a level's height. */
function rounded(level: number): number {
  return Number(level.toPrecision(6))
}
