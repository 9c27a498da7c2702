/** Editing what moves: each change is a step of the map's own history, and no run of the race begins anew. */
import type { EngineError, Track } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { mapOf, wholeBox } from '../engine/tools'
import { t } from '../i18n/drive'
import type { Cell } from '../model/cell'
import { toEngineError } from '../model/errors'
import { isGoal } from '../model/goals'
import {
  brushed,
  crossing,
  type Moving,
  movingOf,
  newTrack,
  trackTo,
  type Walls,
  withMoving,
} from '../model/moving'
import type { Scenario } from '../model/session'
import { announce, commit, notify, scenario } from '../state'
import { mapIsFixed } from '../state/embedding'
import { driveBox, setupNow } from './drive'

/** What presses on the map change: the track or the walls of this number, or new ones; null: nothing of a drive. */
export type Edited = { list: 'tracks' | 'changes'; index: number | null }
export const edited = signal<Edited | null>(null)

/** What a press does to walls. */
export const paint = signal<'block' | 'free'>('block')
/** The step of walls that are still to be drawn. */
export const stepOfNew = signal(10)

/** Why the last change was not made. */
export const refusal = signal<EngineError | null>(null)

export const movingNow = (): Moving => {
  const now = scenario.value
  return now ? movingOf(now) : { changes: [], tracks: [] }
}

/** Makes a change that is known to fit. */
export function make(moving: Moving, gesture?: number): void {
  const now = scenario.peek()
  if (!now || mapIsFixed.peek()) return
  refusal.value = null
  commit(withMoving(now, moving), gesture)
}

/** Makes a change if the engine takes it, and says why where it does not. */
export async function propose(moving: Moving): Promise<boolean> {
  const now = scenario.peek()
  if (!now) return false
  try {
    await wholeBox().call('check', ...mapOf(withMoving(now, moving)))
  } catch (thrown) {
    refusal.value = toEngineError(thrown)
    return false
  }
  if (scenario.peek() === now) make(moving)
  return true
}

export function changeTrack(index: number, change: Partial<Track>): Promise<boolean> {
  const moving = movingNow()
  const tracks = moving.tracks.map((track, i) => (i === index ? { ...track, ...change } : track))
  return propose({ ...moving, tracks })
}

/** Changes stand in the order of their steps; the one that is edited keeps its cells at hand. */
export async function changeStep(index: number, at_step: number): Promise<void> {
  const moving = movingNow()
  const moved = { ...moving.changes[index], at_step }
  const others = moving.changes.filter((_, i) => i !== index)
  const changes = inOrder(others, moved)
  if (await propose({ ...moving, changes }))
    edited.value = { list: 'changes', index: changes.indexOf(moved) }
}

export function changeSight(sight: number | null): Promise<boolean> {
  const { sight: _, ...moving } = movingNow()
  return propose(sight === null ? moving : { ...moving, sight })
}

export function remove({ list, index }: Edited): void {
  const moving = movingNow()
  const left = <T>(all: T[]) => all.filter((_, i) => i !== index)
  edited.value = null
  if (list === 'tracks') make({ ...moving, tracks: left(moving.tracks) })
  else make({ ...moving, changes: left(moving.changes) })
  announce(t('drive.removed'))
}

/** The track in hand goes on to a cell; the first cell of a new one makes it. */
export function extendTrack(to: Cell, gesture: number): void {
  const [now, hand] = [scenario.peek(), edited.peek()]
  if (!now || hand?.list !== 'tracks') return
  const moving = movingOf(now)
  const index = hand.index ?? moving.tracks.length
  const track = trackTo(moving.tracks[index] ?? newTrack([]), to, now)
  if (track === moving.tracks[index] || track.cells.length === 0) return
  const tracks = moving.tracks.slice()
  tracks[index] = track
  edited.value = { list: 'tracks', index }
  make({ ...moving, tracks }, gesture)
}

/** Paints cells into the walls in hand, or out of them; the first cells of new ones make them. */
export function brushWalls(cells: Cell[], leave: boolean, gesture: number): void {
  const [now, hand] = [scenario.peek(), edited.peek()]
  if (!now || hand?.list !== 'changes') return
  tellOfGoals(now, cells, leave)
  const before = movingOf(now)
  const fresh: Walls = { at_step: stepOfNew.peek(), blocked: [], freed: [] }
  const changes = hand.index === null ? inOrder(before.changes, fresh) : before.changes
  const index = hand.index ?? changes.indexOf(fresh)
  const made = brushed(
    withMoving(now, { ...before, changes }),
    index,
    cells,
    leave ? 'leave' : paint.peek(),
  )
  if (isEmpty(made.changes[index])) {
    edited.value = { list: 'changes', index: null }
    make({ ...made, changes: made.changes.filter((_, i) => i !== index) }, gesture)
    return
  }
  edited.value = { list: 'changes', index }
  make(made, gesture)
}

/** Walls come beside a goal, not upon it. */
function tellOfGoals(now: Scenario, cells: Cell[], leave: boolean): void {
  if (leave || paint.peek() !== 'block' || !cells.some((cell) => isGoal(now, cell))) return
  notify('info', t('drive.goalStays'))
}

const isEmpty = (change?: Moving['changes'][number]) =>
  (change?.blocked?.length ?? 0) + (change?.freed?.length ?? 0) === 0

/** Behind all that come at the same step or before it. */
function inOrder<C extends Moving['changes'][number]>(all: Moving['changes'], one: C) {
  const at = all.findIndex(({ at_step }) => at_step > one.at_step)
  return at < 0 ? [...all, one] : [...all.slice(0, at), one, ...all.slice(at)]
}

/** Lets an obstacle cross the best path of the map as it is. */
export async function makeExample(): Promise<void> {
  const [now, setup] = [scenario.peek(), setupNow()]
  if (!now || !setup) return
  const { drive: _, ...spec } = setup.spec
  const still = { ...setup, spec, planner: 'astar', params: {} }
  const path = await driveBox().call('stillPath', still)
  if (scenario.peek() !== now) return
  const track = crossing(now, path)
  const moving = movingOf(now)
  if (track) make({ ...moving, tracks: [...moving.tracks, track] })
  else notify('warning', t('drive.noExample'))
}
