import { reducedMotion } from '../state'

/** Smoothly, so that the reader sees where on the page it went; at once for those who prefer less motion. */
export function bringIntoSight(elementId: string): void {
  const behavior = reducedMotion() ? 'auto' : 'smooth'
  document.getElementById(elementId)?.scrollIntoView({ block: 'nearest', behavior })
}
