/** How far a result is from its reference. */
import type { Reference } from '@pkg/formicarium'
import { type Panel, referenceOf, shownOf } from '../state'

const EQUAL = 1e-9

/** The value of the reference, proven or not. */
export function referenceValue(reference: Reference | null): number | null {
  return reference && 'value' in reference ? reference.value : null
}

/** Relative to the reference; null while either is unknown. 0 exactly when they agree; below 0 only where nothing is proven. */
export function gapOf(
  value: number | null | undefined,
  reference: Reference | null,
): number | null {
  const best = referenceValue(reference)
  if (value == null || best === null) return null
  if (best === 0) return 0
  const gap = value / best - 1
  return Math.abs(gap) < EQUAL ? 0 : gap
}

/** The gap of what a panel shows, by its own objective. */
export function panelGap(panel: Panel): number | null {
  return gapOf(shownOf(panel).summary?.value, referenceOf(panel))
}
