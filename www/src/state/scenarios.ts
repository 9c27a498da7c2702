/** Everything that changes the map or the question asked on it. */

import { batch } from '@preact/signals'
import { type GalleryEntry, gallery } from '../gallery/gallery'
import type { Racer } from '../gallery/paper_maps'
import { t } from '../i18n'
import { applyEditTo, type Edit, refusalOf } from '../model/edit'
import { limits } from '../model/facts'
import { askSame, takenCells } from '../model/goals'
import type { Scenario } from '../model/session'
import { fitView } from '../model/viewpoint'
import { mapIsFixed } from './embedding'
import { createHistory, type Swap } from './history'
import { lazyParts } from './lazy_parts'
import { guide } from './lesson'
import { flushLive } from './live_reports'
import { announce, notify, notifyError } from './notices'
import { dropResults, presetSetup, replacePanels } from './panels'
import { pause, play, reset, restart, showDrawn, walls } from './runs'
import { suitSpeed } from './speed'
import {
  activeGoal,
  galleryId,
  panels,
  phase,
  plannerEntry,
  pressed,
  scenario,
  tool,
  wholeEngine,
} from './store'
import { fetchWholeEngine } from './whole_engine'

const history = createHistory()
export const { canUndo, canRedo } = history

/** Scenarios are immutable and undo brings back the very same object, so the object tells where it came from. */
const galleryIds = new WeakMap<Scenario, string>()

/**
 * Walls and levels before start or goal was taken up: walls it passes over stay, ground it passes over lifts nothing. Only the cell it is
 * left on becomes free.
 */
let dragged: { gesture: number; before: Scenario } | null = null
/** What a press has drawn so far: the page takes it over when it ends, so that nothing moves under the pointer. */
let drawn: { map: Scenario; gesture?: number } | null = null
/** The gesture whose refusal has been said: once is enough. */
let toldOf: number | undefined

/** One edit of the map; edits of the same gesture (a drag) are undone together. */
export function applyEdit(edit: Edit, gesture?: number): void {
  if (mapIsFixed.peek()) return
  const before = drawn?.map ?? scenario.peek()
  if (!before) return
  const base = beforeDrag(before, edit, gesture)
  const after = applyEditTo(base, edit)
  if (after === base) explain(before, edit, gesture)
  else commit(after, gesture)
}

/** Puts a changed scenario in the place of the one on show; undo brings that one back. */
export function commit(after: Scenario, gesture?: number): void {
  const before = drawn?.map ?? scenario.peek()
  if (!before || after === before) return
  if (pressed.peek()) {
    drawn = { map: after, gesture }
    if (!showsOnRuns(after)) showDrawn(after)
    return
  }
  const taken = walls.take?.(before, after)
  if (taken === 'refused') return
  history.record(before, after, gesture)
  if (taken === 'taken' || asksSame(before, after)) rename(after)
  else {
    pauseForEdit()
    replace(after)
  }
}

/** Notes a change of names as one step; the map stays as it is. */
export function noteSwap(swap: Swap, gesture?: number): void {
  const now = scenario.peek()
  if (now) history.record(now, now, gesture, swap)
}

/** From here to the end of the press only the workers' pictures follow what is drawn. */
export function beginPress(): void {
  pressed.value = true
}

export function endPress(): void {
  pressed.value = false
  const made = drawn
  drawn = null
  if (made?.map === scenario.peek()) {
    if (!showsOnRuns(made.map)) restart()
  } else if (made) commit(made.map, made.gesture)
  flushLive()
}

/** Whether what is drawn is shown over runs that go on: its walls are to change while they do. */
function showsOnRuns(map: Scenario): boolean {
  const before = scenario.peek()
  return (before && walls.show?.(before, map)) ?? false
}

/** Says why the ground refuses an edit: the map itself does not show it. */
function explain(now: Scenario, edit: Edit, gesture?: number): void {
  const refusal = refusalOf(now, edit)
  if (refusal === null || (gesture !== undefined && gesture === toldOf)) return
  toldOf = gesture
  notify('warning', t(`terrain.refused.${refusal}`), { hint: t(`terrain.refusedHint.${refusal}`) })
}

/** Only names differ: no run is obsolete. */
function rename(next: Scenario): void {
  scenario.value = next
  galleryId.value = galleryIds.get(next) ?? null
}

/** Whether two scenarios ask the same of a planner. */
export const asksSame = (a: Scenario, b: Scenario) =>
  a.cells === b.cells && a.heights === b.heights && askSame(a.spec, b.spec)

/** Says why the tool that adds goals does nothing; every other tool needs no words. */
export function refuseMoreGoals(): void {
  if (tool.peek() === 'add-goal') notify('warning', t('goals.most', { max: limits.max_goals }))
}

function beforeDrag(now: Scenario, { kind }: Edit, gesture?: number): Scenario {
  if (gesture === undefined || (kind !== 'start' && kind !== 'goal')) return now
  if (dragged?.gesture !== gesture) dragged = { gesture, before: now }
  const { cells, spec } = dragged.before
  if (now.cells === cells && now.spec.terrain === spec.terrain) return now
  return { ...now, cells, spec: { ...now.spec, ...(spec.terrain && { terrain: spec.terrain }) } }
}

export function clearWalls(): void {
  applyEdit({ kind: 'clear' })
}

/** For files that mean 1 as free; no terrain comes that way. Start and goals keep free ground under them. */
export function invertWalls(): void {
  const before = scenario.peek()
  if (!before || before.heights) return
  const { spec } = before
  const cells = before.cells.map((cell) => 1 - cell)
  for (const [x, y] of takenCells(spec)) cells[y * spec.width + x] = 0
  setScenario({ ...before, cells, origin: null }, { undoable: true })
}

/** A different scenario altogether; undo brings the one before it back. Runs that played begin again at once. */
export function setScenario(next: Scenario, options: { undoable: boolean; swap?: Swap }): void {
  const before = scenario.peek()
  const wasRunning = phase.peek() === 'running'
  if (before && options.undoable) history.record(before, next, undefined, options.swap)
  else history.clear()
  guide.value = null
  replace(next)
  fitView()
  if (wasRunning) play()
}

/** When several maps are asked for while one is being fetched, the last counts. */
let asked = 0

export async function openGallery(id: string): Promise<void> {
  const entry = gallery.find((each) => each.id === id)
  if (!entry) return
  const mine = ++asked
  if (entry.racers && wholeEngine.peek() !== 'here') notify('info', t('panels.fetchingMore'))
  const opened = fromGallery(id, await entry.scenario())
  if (entry.racers) await fetchWholeEngine()
  if (mine !== asked) return
  suitSpeed(opened)
  batch(() => {
    if (entry.racers) letRace(entry.racers, entry.group)
    setScenario(opened, { undoable: true })
  })
  if (entry.group === 'papers') offerQuestion()
}

/** Offers to ask the paper's questions again, over many runs. */
function offerQuestion(): void {
  const run = () =>
    void lazyParts
      .lab()
      .then(({ showPublished }) => showPublished())
      .catch(notifyError)
  notify('info', t('notices.paperReported'), {
    action: { label: t('notices.paperReproduced'), run },
  })
}

/** The planners that belong to a map, with a way back to those that were there. */
function letRace(racers: Racer[], group: GalleryEntry['group']): void {
  const before = panels.peek().map(({ setup }) => ({ ...setup, result: null }))
  const setups = racers.map(([planner, preset]) => presetSetup(planner, preset ?? null))
  replacePanels(setups.filter(({ planner }) => plannerEntry(planner)))
  if (before.length === 0) return
  notify('info', t(group === 'terrains' ? 'notices.terrainPlanners' : 'notices.paperPlanners'), {
    action: {
      label: t('notices.formerPlanners'),
      run: () => {
        replacePanels(before)
        restart()
      },
    },
  })
}

/** Notes that a scenario is a built-in one: it has its tick in the gallery for as long as it is unchanged, or is so again. */
export function fromGallery(id: string, built: Scenario): Scenario {
  galleryIds.set(built, id)
  return built
}

export function undo(): void {
  travel('undo', 'redo')
}

export function redo(): void {
  travel('redo', 'undo')
}

function travel(step: 'undo' | 'redo', back: 'undo' | 'redo'): void {
  const now = scenario.peek()
  const target = now && history[step](now)
  if (!now || !target) return
  const next = target.scenario
  const taken = walls.take?.(now, next)
  if (taken === 'refused') {
    history[back](next)
    return
  }
  target.swap?.()
  // Undone in mid-press: what was drawn before is left out.
  drawn = null
  suitSpeed(next)
  if (taken === 'taken' || asksSame(now, next)) rename(next)
  else replace(next)
  if (now.spec.width !== next.spec.width || now.spec.height !== next.spec.height) fitView()
  announce(t(step === 'undo' ? 'notices.undone' : 'notices.redone'))
}

/** The runs on the old map are obsolete; what they have shown stays visible no longer than the map. */
function replace(next: Scenario): void {
  // Undone in mid-press, or another map has come: what was drawn on the one before is left out.
  drawn = null
  batch(() => {
    scenario.value = next
    activeGoal.value = Math.min(activeGoal.peek(), next.spec.goals.length - 1)
    galleryId.value = galleryIds.get(next) ?? null
    dropResults()
    reset()
  })
}

function pauseForEdit(): void {
  if (phase.peek() !== 'running') return
  pause()
  notify('info', t('notices.pausedForEdit'), { hint: t('notices.pausedForEditHint') })
}
