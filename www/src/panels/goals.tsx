/** Where the table of goals stands, and when. */
import { signal } from '@preact/signals'
import { goalsShown, scenario } from '../state'
import { lazily } from '../ui/lazily'

export const GOALS_ID = 'goals'

/** Set until the table has come into sight: it may have to be fetched first. */
export const goalsSought = signal(false)

const GoalsCard = lazily(() => import('./goals_card').then((card) => card.default))

/** There when there is more than one goal, or when somebody asks for it. */
export function Goals() {
  return goalsOnShow() ? <GoalsCard /> : null
}

export function goalsOnShow(): boolean {
  return goalsShown.value || (scenario.value?.spec.goals.length ?? 1) > 1
}

export function showGoals(): void {
  goalsShown.value = true
  goalsSought.value = true
}
