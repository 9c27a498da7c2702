/** Which curves the chart of convergence shows, and of what. */
import { signal } from '@preact/signals'
import { historyOf, objectives, panels, references } from '../state'
import { walls } from '../state/runs'
import { referenceValue } from '../words/gap_words'
import { isWeighted, objectiveWord } from '../words/objective_words'

export const showIterationBest = signal(true)
export const showMean = signal(true)

/** Whether there is no curve yet. */
export const isEmpty = () =>
  panels.value.every(({ id, live }) => !live.value.summary?.metrics && !historyOf(id).hasPath)

const LENGTHS = ['length', 'polyline-length', 'tour-length', 'slice-cost'] as const

/**
 * The references that fit the curves, which show lengths, or costs by slices, whatever the objectives of the panels; and the iteration from
 * which they hold, where walls have changed.
 */
export function levels() {
  const from = walls.since?.() ?? 0
  return LENGTHS.filter((id) => objectives.value.includes(id)).flatMap((objective) => {
    const length = referenceValue(references.value[objective] ?? null)
    return length === null ? [] : [{ objective, length, from }]
  })
}

/** By slices and on weighted ground the curves may show costs instead of lengths. */
export const showsCost = () =>
  isWeighted() ||
  (objectives.value.includes('slice-cost') && objectiveWord('slice-cost') === 'slice-cost')
