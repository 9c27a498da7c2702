/** The readings of its paper that a planner can be run by: presets that the catalog marks, and often its defaults. */
import type { CatalogEntry, PaperReading } from '@pkg/formicarium'
import type { ParamValues } from './messages'
import type { PanelSetup } from './session'

/** In the order in which people meet them. */
export const READINGS = ['printed', 'as-read', 'second-reading'] as const satisfies PaperReading[]

type Preset = CatalogEntry['presets'][number]
type Known = Pick<CatalogEntry, 'presets' | 'reading'>

/** Null where the defaults are the reading. */
export interface OfferedReading {
  reading: PaperReading
  preset: Preset | null
}

/** None of a planner that has no readings. */
export function readingsOf({ presets, reading }: Known): OfferedReading[] {
  return READINGS.flatMap((one): OfferedReading[] => {
    if (one === reading) return [{ reading: one, preset: null }]
    const preset = presets.find((each) => each.reading === one)
    return preset ? [{ reading: one, preset }] : []
  })
}

/** The reading that a planner is run by; null where its values are no reading as a whole. */
export function readingNow(
  { presets, reading }: Known,
  { preset, params }: Pick<PanelSetup, 'preset' | 'params'>,
): PaperReading | null {
  if (preset === null) return (Object.keys(params).length === 0 && reading) || null
  const chosen = presets.find((each) => each.name === preset && hasValuesOf(each, params))
  return chosen?.reading ?? null
}

/** Whether these are a preset's very values: those of an old link may be others by now. */
export const hasValuesOf = ({ values }: Preset, params: ParamValues) =>
  Object.keys(values).length === Object.keys(params).length &&
  Object.entries(values).every(([key, value]) => params[key] === value)
