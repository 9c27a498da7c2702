/** The experiment that is open: how far it is, what is asked, what came out. */

import { Results } from '../results/results'
import { VerificationPanel } from '../share/share_comparison'
import { Asked } from './question_card'
import { RunBar } from './run_bar'

export function StudyView() {
  return (
    <div class="study">
      <RunBar />
      <VerificationPanel />
      <Asked />
      <Results />
    </div>
  )
}
