/** Whether the table of goals is on show. */
import { goalsShown, scenario, seek } from '../state'

export const GOALS_ID = 'goals'

export function goalsOnShow(): boolean {
  return goalsShown.value || (scenario.value?.spec.goals.length ?? 1) > 1
}

export function showGoals(): void {
  goalsShown.value = true
  seek('goals')
}
