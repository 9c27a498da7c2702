/** Whether the reader wants metres or cells, on maps that have a scale. */
import { signal } from '@preact/signals'
import { recall, remember } from './appearance'

export type LengthUnit = 'metres' | 'cells'

const KEY = 'formicarium.lengths'

export const lengthUnit = signal<LengthUnit>(recall(KEY) === 'cells' ? 'cells' : 'metres')

export function setLengthUnit(unit: LengthUnit): void {
  lengthUnit.value = unit
  // Nothing stored means metres.
  remember(KEY, unit === 'cells' ? unit : '')
}
