/** Tells screen readers how a race goes: its start, first and better paths, its end. */
import { effect, untracked } from '@preact/signals'
import { t } from '../i18n'
import { announce, liveTick, type Panel, panels, phase } from '../state'
import { gapShown, panelGap } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import { panelTitle } from '../words/planner_words'

/** Better paths come faster than anybody can hear of them: one in so many milliseconds is told. */
const PAUSE_MS = 4000

/** Of each panel the length that was last told; none before its first path. */
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
    const length = panel.live.peek().summary?.metrics?.length
    if (length === undefined) told.delete(panel.id)
    else tellPath(panel, length)
  }
}

function tellPath({ id }: Panel, length: number): void {
  const last = told.get(id)
  const now = performance.now()
  if (last !== undefined && (length >= last || now - toldAt < PAUSE_MS)) return
  told.set(id, length)
  toldAt = now
  const words = { planner: panelTitle(id), length: lengthShown(length) }
  announce(t(last === undefined ? 'notices.firstPath' : 'notices.betterPath', words))
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
  return length === undefined ? t('gap.noPathYet') : lengthShown(length)
}
