/** What planners have proven of the results on show, asked of the panels' workers where a run rests or has ended. */
import type { Certificate, RunSummary } from '@pkg/formicarium'
import { effect, signal } from '@preact/signals'
import { client } from '../engine/panel_clients'
import type { PanelAnswers } from '../model/messages'
import { shownOf } from './looking'
import { paramValue } from './panels'
import { type Panel, panels, phase, plannerEntry } from './store'

const known = signal(new Map<number, PanelAnswers['certificate']>())

/** The parameter of a colony that says how much a proof may take; 0 is none. */
const PROOF_LIMIT = 'proof_limit'

/** Whether its planner proves something of its results. */
export function proves({ setup }: Panel): boolean {
  const entry = plannerEntry(setup.planner)
  const limit = entry?.params.find(({ key }) => key === PROOF_LIMIT)
  return entry?.family === 'exact' || (limit !== undefined && Number(paramValue(setup, limit)) > 0)
}

/** Null while it is not known, and where nothing is proven. */
export function certificateOf(panel: Panel): Certificate | null {
  const found = known.value.get(panel.id)
  return found && found.digest === shownOf(panel).summary?.digest ? found.certificate : null
}

/** A run that has not begun has proven nothing, and is not asked while it may be replaced. */
const rests = ({ status, effort }: RunSummary, moves: boolean) =>
  status !== 'running' || (!moves && effort.iterations > 0)

/** Asks until it is told to stop. */
export function keepCertificates(): () => void {
  const asked = new Map<number, object>()
  return effect(() => {
    const moves = phase.value === 'running'
    for (const panel of panels.value) {
      const { summary } = shownOf(panel)
      if (!summary || !rests(summary, moves) || !proves(panel)) continue
      if (asked.get(panel.id) === summary) continue
      asked.set(panel.id, summary)
      void ask(panel.id)
    }
  })
}

/** The answer may be about more than the page has yet heard of: then the next frame asks again. */
async function ask(panelId: number): Promise<void> {
  const answer = await client(panelId)?.ask({ about: 'certificate' })
  if (answer) known.value = new Map(known.peek()).set(panelId, answer)
}
