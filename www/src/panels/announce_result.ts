/** Tells screen readers the outcome of a race. */
import { effect, untracked } from '@preact/signals'
import { numbers, t } from '../i18n'
import { announce, type Panel, panels, phase } from '../state'
import { gapShown, panelGap } from '../words/gap_words'
import { panelTitle } from '../words/planner_words'

export function announceResults(): void {
  effect(() => {
    if (phase.value !== 'finished') return
    untracked(() => announce(t('notices.finished', { results: results() })))
  })
}

function results(): string {
  return panels
    .peek()
    .map((panel) => `${panelTitle(panel.id)} ${outcome(panel)}`)
    .join(', ')
}

/** The gap; the length where there is no reference. */
function outcome(panel: Panel): string {
  const gap = panelGap(panel)
  if (gap !== null) return gapShown(gap)
  const length = panel.live.peek().summary?.metrics?.length
  return length === undefined ? t('gap.noPathYet') : numbers.peek().length.format(length)
}
