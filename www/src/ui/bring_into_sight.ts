import { reducedMotion } from '../state'

/** Scrolls smoothly, so that the reader sees where it goes; at once for readers who prefer less motion. */
export function bringIntoSight(elementId: string): void {
  const behavior = reducedMotion() ? 'auto' : 'smooth'
  document.getElementById(elementId)?.scrollIntoView({ block: 'nearest', behavior })
}
