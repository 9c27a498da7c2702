/** The cards that tell what a paper claims, what we do where it is silent, and what came out: which is about what, and which is open. */

import cards from 'virtual:paper-cards'
import { signal } from '@preact/signals'
import { show } from '../state/dialogs'

/** Not about one paper: how claims are measured and judged. */
export const METHODOLOGY = 'methodology'

/** The card that is open, by name. */
export const openCard = signal('')

/** The card about a planner with a preset; null when none was written. */
export function cardOf(planner: string, preset: string | null = null): string | null {
  return cards[`${planner} ${preset}`] ?? cards[planner] ?? null
}

export function showCard(card: string): void {
  openCard.value = card
  show('paper')
}
