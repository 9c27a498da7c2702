/** Layers of maps in words: their name with its unit, their values. */
import type { Layer } from '@pkg/formicarium'
import { language } from '../i18n'
import { t } from '../i18n/reading'
import { metresPerCell } from './metres'
import { isSearch } from './planner_words'

export function layerTitle(layer: Layer): string {
  const name = t(`view.layers.${layer}`)
  if (isOfLength(layer)) return t('lengths.inMetres', { what: name })
  const unit = t(`legend.units.${layer}`)
  return unit === '' ? name : `${name} (${unit})`
}

/** Whether its values are lengths and are shown in metres. */
const isOfLength = (layer: Layer) =>
  (layer === 'cost' || layer === 'scent') && metresPerCell.value !== null

/** A value of a layer as it is shown. */
export const layerNumber = (layer: Layer) => (value: number) =>
  scaleNumber(isOfLength(layer) ? value * (metresPerCell.value ?? 1) : value)

/** Three digits of anything; what is far from 1 as a power of ten. */
export function scaleNumber(value: number): string {
  const size = Math.abs(value)
  const notation = size !== 0 && (size < 0.001 || size >= 1e6) ? 'scientific' : 'standard'
  return new Intl.NumberFormat(language.value, { maximumSignificantDigits: 3, notation }).format(
    value,
  )
}

/** What a layer that knows two values alone says with the lower and the upper one; null for any other. */
export function categoriesOf(layer: Layer, planner: string): [string, string] | null {
  if (layer === 'seed-path') return [t('legend.elsewhere'), t('legend.onPath')]
  if (layer === 'merged') return [t('legend.elsewhere'), t('legend.merged')]
  if (layer === 'visits' && isSearch(planner)) return [t('legend.elsewhere'), t('legend.expanded')]
  return null
}
