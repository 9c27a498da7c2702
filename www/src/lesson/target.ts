/** Who has come how close to the target. */
import { computed } from '@preact/signals'
import { lesson, panels, references } from '../state'
import { referenceValue } from '../words/gap_words'
import { panelTitle } from '../words/planner_words'
import { handValue, measured } from './hand_panel'

/** Values that differ by less are the same. */
const EQUAL = 1e-9

export type Standing =
  | { kind: 'waiting' | 'unknown' | 'noPath' | 'none' | 'nobody' }
  /** `by`: how much it lacks, or is better; 0 for what is reached. */
  | { kind: 'closest' | 'beaten' | 'reached'; who: string; value: number; by: number }

interface Contestant {
  who: string
  value: number | null
}

/** The value that is to be beaten or reached; null while it is not known. */
export const targetValue = computed((): number | null => {
  const target = lesson.value?.target
  if (!target) return null
  if (target.beat !== 'optimum') return target.beat
  const reference = references.value[target.objective] ?? null
  return reference?.kind === 'unproven' ? null : referenceValue(reference)
})

export const standing = computed((): Standing | null => {
  const target = lesson.value?.target
  if (!target) return null
  const value = targetValue.value
  if (value === null) return { kind: whyUnknown() }
  const all = contestants()
  if (all.length === 0) return { kind: 'none' }
  const reached = all.flatMap(({ who, value }) => (value === null ? [] : [{ who, value }]))
  const best = reached.toSorted((a, b) => a.value - b.value)[0]
  if (!best) return { kind: 'nobody' }
  const lacks = best.value - value
  if (target.beat === 'optimum' && lacks <= EQUAL) return { kind: 'reached', ...best, by: 0 }
  if (lacks < -EQUAL) return { kind: 'beaten', ...best, by: -lacks }
  return { kind: 'closest', ...best, by: Math.max(0, lacks) }
})

function whyUnknown(): 'waiting' | 'unknown' | 'noPath' | 'none' {
  const target = lesson.value?.target
  if (!target || contestants().length === 0) return 'none'
  const reference = references.value[target.objective]
  if (!reference) return 'waiting'
  return reference.kind === 'no-path' ? 'noPath' : 'unknown'
}

/** Only those that are measured by the target's objective. */
function contestants(): Contestant[] {
  const objective = lesson.value?.target?.objective
  if (!objective) return []
  const planners = panels.value
    .filter(({ live }) => live.value.objective === objective)
    .map(({ id, live }) => ({ who: panelTitle(id), value: live.value.summary?.value ?? null }))
  const hand = measured.value?.drawn
  return hand ? [...planners, { who: hand.label, value: handValue(objective) }] : planners
}
