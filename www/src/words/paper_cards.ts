/** The cards that tell what a paper claims, what we do where it is silent, and what came out. The same files as in docs/papers. */

import cards from 'virtual:paper-cards'
import { signal } from '@preact/signals'
import { show } from '../state/dialogs'

const texts = import.meta.glob<string>(
  ['../../../docs/papers/*.md', '../../../docs/methodology.md'],
  { query: '?raw', import: 'default' },
)

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

export async function cardText(card: string): Promise<string> {
  const file = card === METHODOLOGY ? card : `papers/${card}`
  const fetched = texts[`../../../docs/${file}.md`]
  if (!fetched) throw new Error(`there is no card ${card}`)
  return fetched()
}
