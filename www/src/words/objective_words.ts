/** The objective of a result in words; by slices the reader chooses between cost and length. */
import type { Objective } from '@pkg/formicarium'
import { scenario } from '../state'

export type ObjectiveWord = Objective | 'slice-length'

export function objectiveWord<O extends Objective>(objective: O): O | 'slice-length' {
  const measure = scenario.value?.spec.terrain?.slices?.measure
  return objective === 'slice-cost' && measure === 'length' ? 'slice-length' : objective
}
