/** Tells screen readers how a race goes: its start, first and better paths, its end. */
import type { Objective } from '@pkg/formicarium'
import { effect, untracked } from '@preact/signals'
import { t } from '../i18n'
import { announce, liveTick, type Panel, panels, phase } from '../state'
import { gapShown, panelGap } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import { OTHER_VALUES, objectiveWord } from '../words/objective_words'
import { panelTitle } from '../words/planner_words'

/** Better paths come faster than anybody can hear of them: one in so many milliseconds is told. */
const PAUSE_MS = 4000

/** Of each panel the value that was last told, by its own objective; none before its first path. */
const told = new Map<number, number>()
let toldAt = 0

export function announceRuns(): void {
  let before = phase.peek()
  effect(() => {
    const now = phase.value
    if (now === 'running' && before === 'editing') announce(t('notices.started'))
    if (now === 'finished') untracked(() => announce(t('notices.finished', { results: results() })))
    before = now
  })
  effect(() => {
    liveTick.value
    if (phase.value === 'running') untracked(tellPaths)
  })
}

/** Before a first path a run has begun anew, and what was told of it is forgotten. */
function tellPaths(): void {
  for (const panel of panels.peek()) {
    const { summary } = panel.live.peek()
    if (summary?.value == null) told.delete(panel.id)
    else tellPath(panel, summary.objective, summary.value)
  }
}

function tellPath({ id }: Panel, objective: Objective, value: number): void {
  const last = told.get(id)
  const now = performance.now()
  if (last !== undefined && (value >= last || now - toldAt < PAUSE_MS)) return
  told.set(id, value)
  toldAt = now
  const words = { planner: panelTitle(id), value: valueWords(objective, value) }
  announce(t(last === undefined ? 'notices.firstPath' : 'notices.betterPath', words))
}

function results(): string {
  return panels
    .peek()
    .map((panel) => `${panelTitle(panel.id)} ${outcome(panel)}`)
    .join(', ')
}

/** What the path is judged by, and what it comes to. */
function valueWords(objective: Objective, value: number): string {
  const label = OTHER_VALUES[objectiveWord(objective)] ?? 'metrics.length'
  return `${t(label)} ${lengthShown(value)}`
}

/** The gap; the value where there is no reference. */
function outcome(panel: Panel): string {
  const gap = panelGap(panel)
  if (gap !== null) return gapShown(gap)
  const { summary } = panel.live.peek()
  if (summary?.value == null) return t('gap.noPathYet')
  return valueWords(summary.objective, summary.value)
}
