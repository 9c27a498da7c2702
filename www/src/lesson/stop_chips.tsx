/** On the map of a panel that has met a stop: which. */
import { stopsMet } from '../state'
import { metBy, stopWords } from './stop_words'

export function StopChips({ panelId }: { panelId: number }) {
  if (stopsMet.value.length === 0) return null
  const met = metBy(panelId)
  if (met.length === 0) return null
  return (
    <p class="chip stop-chip" data-testid={`stop-met-${panelId}`}>
      {met.map(stopWords).join(', ')}
    </p>
  )
}
