/** The open comparison: how far it is, what it asks, what came out. */
import { Results } from '../results/results'
import { CollectedCard, ShareCard, VerificationPanel } from '../share/share_comparison'
import { QuestionCard } from './question_card'
import { RunBar } from './run_bar'

export function ComparisonView() {
  return (
    <div class="open-comparison">
      <RunBar />
      <ShareCard />
      <CollectedCard />
      <VerificationPanel />
      <QuestionCard />
      <Results />
    </div>
  )
}
