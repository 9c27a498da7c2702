/** The state machine of the runs: editing → running ⇄ paused → finished, and back to editing by any change. */
import { batch } from '@preact/signals'
import { createConductor } from '../engine/conductor'
import type { RunSetup } from '../model/messages'
import { DEFAULT_SPEED, LEAD_IN_SPEED, type Scenario, type Session } from '../model/session'
import { askToEnd, lesson, stopsMet } from './lesson'
import { clearLive, flushLive, forget, latest, onReply } from './live_reports'
import { leavePast } from './looking'
import { allowed } from './memory'
import {
  liveTick,
  type Panel,
  panels,
  phase,
  plannerEntry,
  scenario,
  seed,
  speed,
  sync,
} from './store'
import { fetchWholeEngine } from './whole_engine'

/** What changes of walls in a run need of it (state/changing_walls.ts, fetched when somebody wants it). */
export interface WallsPart {
  /** A change that is being drawn: shown over the runs while they go on. False where they are to start anew. */
  show(before: Scenario, after: Scenario): boolean
  /** An edit that is about to be made: taken as a change of the runs, refused, or runs are to start anew. */
  take(before: Scenario, after: Scenario): 'taken' | 'refused' | 'anew'
  /** The setup with the changes of the panel's run. */
  setup(panel: Panel, bare: RunSetup): RunSetup
  /** The session whose runs begin next, in these panels. */
  next(session: Session, panelIds: number[]): void
  /** All runs begin. */
  begin(): void
  inSession(): Pick<Session, 'changes' | 'keepTrails'>
  /** Changes of the runs on show: the map of the page has had all of them. */
  made(): number
  /** The iteration at whose end the last one was made in every panel; 0 where there was none. */
  since(): number
}

/** Empty until it has been fetched. */
export const walls: Partial<WallsPart> = {}

const conductor = createConductor({
  panelIds: () => panels.peek().map((panel) => panel.id),
  speed: () => (isLeadIn() ? LEAD_IN_SPEED : speed.peek()),
  sync: () => sync.peek(),
  stops: () => lesson.peek()?.stops,
  onReply,
  onMet(met) {
    stopsMet.value = met
    if (met.length === 0) return
    flushLive()
    phase.value = 'paused'
  },
  onAllFinished: () => {
    flushLive()
    phase.value = 'finished'
  },
})

let lastRunId = 0
let leadsIn = false

/** The race of a first visit begins faster: until its colonies have brought paths there is nothing to compare. */
export function leadIn(): void {
  leadsIn = true
}

function isLeadIn(): boolean {
  leadsIn &&=
    speed.peek() === DEFAULT_SPEED &&
    panels.peek().every(({ id }) => !latest(id).summary?.effort.constructed_paths)
  return leadsIn
}

/** Whether no run is being advanced, and no step waits. */
export const isIdle = () => conductor.isIdle()

export function play(): void {
  if (!scenario.peek() || panels.peek().length === 0) return
  if (phase.peek() === 'running' || !allowed()) return
  leavePast()
  if (phase.peek() === 'finished') reset()
  phase.value = 'running'
  conductor.play()
}

export function pause(): void {
  conductor.pause()
  if (phase.peek() === 'running') phase.value = 'paused'
}

export function toggle(): void {
  if (phase.peek() === 'running') pause()
  else play()
}

export function stepMove(): void {
  step(() => conductor.step('move'))
}

export function stepIteration(): void {
  step(() => conductor.step('iteration'))
}

/** Where there are stops, somebody has to say whether they count. */
export function runToEnd(): void {
  if (lesson.peek()?.stops) askToEnd.value = true
  else runOn(true)
}

/** To the end of all runs, or to the first stop. */
export function runOn(through: boolean): void {
  if (!scenario.peek() || panels.peek().length === 0 || phase.peek() === 'finished') return
  if (!allowed()) return
  leavePast()
  phase.value = 'running'
  conductor.runToEnd(through)
}

/** The picture of a map that is being drawn: runs rest, and all else on the page still tells of the map before. */
export function showDrawn(map: Scenario): void {
  conductor.pause()
  loadAll(map, bareSetup)
}

/** Every run back to its beginning, on the same map with the same seed. */
export function reset(): void {
  conductor.pause()
  leadsIn = false
  stopsMet.value = []
  leavePast()
  walls.begin?.()
  const now = scenario.peek()
  if (panels.peek().some(({ setup }) => !plannerEntry(setup.planner))) void fetchWholeEngine()
  batch(() => {
    phase.value = 'editing'
    for (const { id } of panels.peek()) clearLive(id)
    if (now) loadAll(now, runSetup)
    liveTick.value = liveTick.peek() + 1
  })
}

function loadAll(map: Scenario, setupOf: typeof runSetup): void {
  for (const panel of panels.peek()) conductor.load(panel.id, ++lastRunId, setupOf(panel, map))
}

/** After a change that makes the runs obsolete: begin again, and go on playing if they played. */
export function restart(): void {
  const wasRunning = phase.peek() === 'running'
  reset()
  if (wasRunning) play()
}

export function runSetup(panel: Panel, on: Scenario): RunSetup {
  const bare = bareSetup(panel, on)
  return walls.setup?.(panel, bare) ?? bare
}

/** A run on this very map, whatever has changed in the runs on show. */
function bareSetup({ setup: { planner, params } }: Panel, on: Scenario): RunSetup {
  const { spec: asked, cells, heights, factors } = on
  // What moves once a robot drives is nothing to a planner.
  const { drive, ...spec } = asked
  return { spec, cells, heights, factors, planner, params, seed: seed.peek() }
}

/** Repeats a panel's run up to an iteration, with the changes of its walls. */
export function reload(panel: Panel, ahead: number): void {
  const now = scenario.peek()
  clearLive(panel.id)
  if (now) conductor.load(panel.id, ++lastRunId, { ...runSetup(panel, now), ahead })
}

/** Ends the worker of a panel that is leaving the page. */
export function dropRun(panelId: number): void {
  conductor.drop(panelId)
  forget(panelId)
}

function step(by: () => void): void {
  if (!scenario.peek() || phase.peek() === 'finished' || !allowed()) return
  // Steps wait in line; pausing would clear it, so only playing is paused.
  if (phase.peek() === 'running') pause()
  leavePast()
  phase.value = 'paused'
  by()
}
