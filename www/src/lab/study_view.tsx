/** The experiment that is open: how far it is, what is asked, what came out. */
import { Asked } from './asked'
import { Results } from './results/results'
import { RunBar } from './run_bar'
import { VerificationPanel } from './share/share_study'

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
