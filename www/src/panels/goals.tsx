/** Where the table of goals stands. */
import { lazily } from '../ui/lazily'
import { goalsOnShow } from './goals_shown'

const GoalsCard = lazily(() => import('./goals_card').then((card) => card.default))

/** Shown when there are several goals, or when the reader asks for it. */
export function Goals() {
  return goalsOnShow() ? <GoalsCard /> : null
}
