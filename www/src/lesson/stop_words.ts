/** Stops and who has met them, in words. */
import { effect } from '@preact/signals'
import { numbers } from '../i18n'
import { t } from '../i18n/lesson'
import type { MetStop, Stop } from '../model/lesson'
import { latest, notify, phase, stopsMet } from '../state'
import { panelTitle } from '../words/planner_words'

export function stopWords(stop: Stop): string {
  const iterations = 'iterations' in stop ? numbers.value.whole.format(stop.iterations) : ''
  return t(`lesson.stops.met.${stop.when}`, { iterations })
}

/** What one panel has met, e.g. for its chip; empty where it has met nothing. */
export const metBy = (panelId: number): Stop[] =>
  stopsMet.value.filter((met) => met.panelId === panelId).map(({ stop }) => stop)

/** Says once who has met what, and what to do next. */
export function tellWhenMet(): void {
  effect(() => {
    const met = stopsMet.value
    if (met.length > 0) queueMicrotask(() => tell(met))
  })
}

function tell(met: MetStop[]): void {
  const panels = [...new Set(met.map(({ panelId }) => panelId))]
  const all = panels
    .map((id) => `${panelTitle(id)}: ${metBy(id).map(stopWords).join(', ')}`)
    .join('; ')
  const reached = panels.map((id) => latest(id).summary?.iteration ?? 0)
  const iteration = numbers.peek().whole.format(Math.max(...reached))
  const hint = t(phase.peek() === 'finished' ? 'lesson.stops.nextEnded' : 'lesson.stops.next')
  notify('info', t('lesson.stops.stoppedAt', { iteration, all }), { hint })
}
