/** The objective of a result in words; by slices the reader chooses between cost and length, on weighted ground lengths are costs. */
import type { Objective } from '@pkg/formicarium'
import type { TextKey } from '../i18n'
import { groundsOf } from '../model/terrain'
import { scenario } from '../state'

export type ObjectiveWord = Objective | 'slice-length' | 'cost'

/** Whether a way may cost more than its length. */
export const isWeighted = () => scenario.value !== null && groundsOf(scenario.value).length > 1

export function objectiveWord<O extends Objective>(objective: O): O | 'slice-length' | 'cost' {
  const measure = scenario.value?.spec.terrain?.slices?.measure
  if (isWeighted() && /length$/.test(objective)) return 'cost'
  return objective === 'slice-cost' && measure === 'length' ? 'slice-length' : objective
}

/** Short names of objectives that are no length. */
export const OTHER_VALUES: Partial<Record<ObjectiveWord, TextKey>> = {
  'turn-index': 'metrics.turnIndex',
  weighted: 'metrics.weighted',
  'tour-weight': 'metrics.weightShort',
  'slice-cost': 'metrics.costShort',
  cost: 'metrics.costShort',
}
