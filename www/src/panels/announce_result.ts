/** Says the outcome of a race to those who cannot see it. */
import { effect, untracked } from '@preact/signals'
import { numbers, t } from '../i18n'
import { announce, optimum, panels, phase } from '../state'
import { gapOf } from './gap'
import { panelTitle } from './planner_text'

export function announceResults(): void {
  effect(() => {
    if (phase.value !== 'finished') return
    untracked(() => announce(t('notices.finished', { results: results() })))
  })
}

function results(): string {
  return panels
    .peek()
    .map(({ id, live }) => {
      const gap = gapOf(live.peek().summary?.metrics?.length, optimum.peek())
      const words = gap === null ? t('gap.noPathYet') : numbers.peek().percent.format(gap)
      return `${panelTitle(id)} ${words}`
    })
    .join(', ')
}
