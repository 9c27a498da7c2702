/** Whether the table of goals is on show, and whether it is to come into sight. */
import { signal } from '@preact/signals'
import { goalsShown, scenario } from '../state'

export const GOALS_ID = 'goals'

/** Set until the table has come into sight: it may have to be fetched first. */
export const goalsSought = signal(false)

export function goalsOnShow(): boolean {
  return goalsShown.value || (scenario.value?.spec.goals.length ?? 1) > 1
}

export function showGoals(): void {
  goalsShown.value = true
  goalsSought.value = true
}
