/** What a panel's run has proven. */
import type { Certificate, RunSummary } from '@pkg/formicarium'
import type { PanelAnswers } from '../model/messages'

interface Proving {
  summary(): RunSummary
  /** Only the whole engine tells it. */
  certificate?(): Certificate | undefined
}

export function certificateOf(run: Proving): PanelAnswers['certificate'] {
  const summary = run.summary()
  const certificate = run.certificate ? (run.certificate() ?? null) : atItsEnd(summary)
  return { digest: summary.digest, certificate }
}

/** Of the core: how a search has ended says as much. */
function atItsEnd({ status, value, effort }: RunSummary): Certificate | null {
  if (status !== 'optimal' || value === null) return null
  return { lower_bound: value, expansions: effort.cell_expansions, complete: true }
}
