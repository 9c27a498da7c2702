/** Which curves the chart of convergence shows, and of what. */
import { signal } from '@preact/signals'
import { objectives, panels, references } from '../state'
import { referenceValue } from '../words/gap_words'
import { objectiveWord } from '../words/objective_words'

export const showIterationBest = signal(true)
export const showMean = signal(true)

/** Whether there is no curve yet. */
export const isEmpty = () => panels.value.every(({ live }) => !live.value.summary?.metrics)

const LENGTHS = ['length', 'polyline-length', 'tour-length', 'slice-cost'] as const

/** The references that fit the curves, which show lengths, or costs by slices, whatever the objectives of the panels. */
export function levels() {
  return LENGTHS.filter((id) => objectives.value.includes(id)).flatMap((objective) => {
    const length = referenceValue(references.value[objective] ?? null)
    return length === null ? [] : [{ objective, length }]
  })
}

/** By slices the curves may show costs instead of lengths. */
export const showsCost = () =>
  objectives.value.includes('slice-cost') && objectiveWord('slice-cost') === 'slice-cost'
