/** How far a result is from its reference. */
import type { Reference } from '@pkg/formicarium'
import { numbers } from '../i18n'
import { gapText, relativeGap } from '../model/gap'
import { type Panel, referenceOf, shownOf } from '../state'

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
  return value == null || best === null ? null : relativeGap(value, best)
}

/** A gap in the reader's language, wherever one is shown. */
export const gapShown = (gap: number): string => gapText(gap, numbers.value.percent)

/** The gap of what a panel shows, by its own objective. */
export function panelGap(panel: Panel): number | null {
  return gapOf(shownOf(panel).summary?.value, referenceOf(panel))
}
