/** The smooth curves of the paths on show, asked of the panels' workers whenever a path has changed. */
import type { Smoothed } from '@pkg/formicarium'
import { effect, signal } from '@preact/signals'
import { client } from '../engine/panel_clients'
import type { PanelAnswers } from '../model/messages'
import { shownOf } from './looking'
import { type Panel, panels, scenario } from './store'

const known = signal(new Map<number, PanelAnswers['curve']>())

/** Null while it is not known, and where there is none. */
export function curveOf(panel: Panel): Smoothed | null {
  const found = known.value.get(panel.id)
  const { bestPath } = shownOf(panel)
  return found && bestPath && found.path.join() === bestPath.join() ? found.curve : null
}

/** Asks until it is told to stop. */
export function keepCurves(): () => void {
  const asked = new Map<number, Uint32Array>()
  return effect(() => {
    if (!scenario.value?.spec.vehicle.smoothing) return
    for (const panel of panels.value) {
      const { bestPath } = shownOf(panel)
      if (!bestPath?.length || asked.get(panel.id) === bestPath) continue
      asked.set(panel.id, bestPath)
      void ask(panel.id)
    }
  })
}

/** The answer may be about a path that the page has not yet heard of: then the next frame asks again. */
async function ask(panelId: number): Promise<void> {
  const answer = await client(panelId)?.ask({ about: 'curve' })
  if (answer) known.value = new Map(known.peek()).set(panelId, answer)
}
