/** Where the table of goals stands. */
import { lazily } from '../ui/lazily'
import { goalsOnShow } from './goals_shown'

const GoalsCard = lazily(() => import('./goals_card').then((card) => card.default))

/** There when there is more than one goal, or when somebody asks for it. */
export function Goals() {
  return goalsOnShow() ? <GoalsCard /> : null
}
