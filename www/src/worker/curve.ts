/** The smooth curve of the path that a panel's run shows, worked out once. */
import type { Smoothed } from '@pkg/formicarium'
import type { PanelAnswers } from '../model/messages'

/** Only the whole engine has curves. */
interface Curved {
  best_path(): Uint32Array
  smoothed?(): Smoothed | undefined
}

let last: (PanelAnswers['curve'] & { run: Curved }) | null = null

/** With its path; null where there is none. */
export function curveOf(run: Curved): PanelAnswers['curve'] {
  const path = run.best_path()
  if (last?.run !== run || path.join() !== last.path.join())
    last = { run, path, curve: run.smoothed?.() ?? null }
  return { path, curve: last.curve }
}

/** To be called when what is free has changed: the curve of the same path may be another one. */
export function forgetCurve(): void {
  last = null
}
