/** What the page around this one hears of by itself: paths, ends, another session. */
import { effect, untracked } from '@preact/signals'
import type { RunMoment } from '../../model/embed_messages'
import { caption, liveTick, type Panel, panels, scenario, seed } from '../../state'
import type { Parent } from './messages'

/** What was told of a panel's run; nothing before its first path. */
interface Told {
  best: number
  ended: boolean
}

export function tellEvents(parent: Parent): void {
  tellRuns(parent)
  tellSessions(parent)
}

function tellRuns(parent: Parent): void {
  const told = new Map<number, Told>()
  effect(() => {
    liveTick.value
    untracked(() => {
      for (const [at, panel] of panels.peek().entries()) tellRun(parent, told, panel, at)
    })
  })
}

/** A run that has begun anew has no path, and what was told of it is forgotten. */
function tellRun({ tell }: Parent, told: Map<number, Told>, panel: Panel, at: number): void {
  const { summary } = panel.live.peek()
  if (!summary || (summary.value === null && summary.status === 'running')) {
    told.delete(panel.id)
    return
  }
  const { iteration, iteration_of_best, value, objective, status, digest, metrics } = summary
  const last = told.get(panel.id)
  const { planner } = panel.setup
  const length = metrics?.length ?? null
  const moment: RunMoment = { panel: at, planner, iteration, length, value, objective }
  const best = value ?? Number.POSITIVE_INFINITY
  const ended = status !== 'running'
  if (value !== null && (last === undefined || best < last.best)) {
    const found = { ...moment, iteration: iteration_of_best ?? iteration }
    tell(last === undefined ? 'first-path' : 'better-path', found)
  }
  if (ended && !last?.ended) tell('end', { ...moment, status, digest })
  told.set(panel.id, { best, ended })
}

function tellSessions({ tell }: Parent): void {
  let isFirst = true
  let waits = false
  effect(() => {
    scenario.value
    panels.value
    seed.value
    caption.value
    if (isFirst || waits) return
    waits = true
    // One action changes several of them.
    queueMicrotask(() => {
      waits = false
      tell('session', {
        map: scenario.peek()?.spec.name ?? '',
        title: caption.peek().title,
        seed: seed.peek(),
        planners: panels.peek().map(({ setup }) => setup.planner),
      })
    })
  })
  isFirst = false
}
