/** The ant that is followed: asked of a copy of its run that a worker of its own repeats, so that the run on the page stays as it is. */
import type { AntMove, AntTurn } from '@pkg/formicarium'
import { batch, computed, effect, signal, untracked } from '@preact/signals'
import { type LessonBox, newLessonBox } from '../engine/lesson_box'
import type { Followed } from '../model/lesson_calls'
import type { RunSetup } from '../model/messages'
import {
  lessonMode,
  liveTick,
  lookedAt,
  notifyError,
  type Panel,
  panelById,
  scenario,
  seed,
  shownOf,
} from '../state'
import { askedAbout, guessMoves } from './questions'

export interface FollowedAnt {
  panelId: number
  /** From 0. */
  ant: number
}

/** What is known of the followed ant. */
export interface Seen extends FollowedAnt {
  at: Followed
  /** Moves looked ahead, beyond where the run stands. */
  ahead: number
  /** Null where there is no such ant. */
  turn: AntTurn | null
  /** x and y by number, −1 for lost ants; empty before the first move. */
  ants: Int32Array
  /** The move that it made last, as it had weighed it; null where that was not watched. */
  last: AntMove | null
}

export const followed = signal<FollowedAnt | null>(null)
/** Moves to look ahead, from where the run stands. */
export const ahead = signal(0)
export const seen = signal<Seen | null>(null)

/** Where a copy of the run is to go. */
interface Wish extends FollowedAnt {
  setup: RunSetup
  iteration: number
  moves: number
  ahead: number
}

export function follow(panelId: number, ant: number): void {
  batch(() => {
    followed.value = { panelId, ant }
    ahead.value = 0
    lessonMode.value = 'follow'
  })
}

export function stopFollowing(): void {
  batch(() => {
    followed.value = null
    seen.value = null
    ahead.value = 0
    lessonMode.value = null
  })
}

const followedPanel = computed(() => panelById(followed.value?.panelId ?? -1) ?? null)
const panelSetup = computed(() => followedPanel.value?.setup ?? null)

/** The same object as long as the run is the same, whichever of its ants is followed. */
const setup = computed((): RunSetup | null => {
  const now = scenario.value
  seed.value
  if (!panelSetup.value || !now) return null
  const { planner, params } = panelSetup.value
  const { spec, cells, heights, factors } = now
  return { spec, cells, heights, factors, planner, params, seed: seed.value }
})

/** In a guess the walk of the question, else where the run stands on the page, and so many moves ahead. */
function wish(): Wish | null {
  const who = followed.value
  const panel = followedPanel.value
  if (!who || !panel || !setup.value) return null
  const common = { ...who, setup: setup.value }
  const question = lessonMode.value === 'guess' ? askedAbout.value : null
  if (question)
    return { ...common, iteration: question.iteration, moves: guessMoves.value, ahead: 0 }
  const standing = standingOf(panel)
  return standing && { ...common, ...standing, ahead: ahead.value }
}

function standingOf(panel: Panel): { iteration: number; moves: number } | null {
  liveTick.value
  lookedAt.value
  const { summary } = shownOf(panel)
  return summary && { iteration: summary.iteration, moves: summary.moves }
}

export function keepFollowing(): void {
  // A run that has moved on is where the look ahead begins anew.
  let stood = ''
  effect(() => {
    const now = wish()
    const stands = now ? [now.panelId, now.iteration, now.moves].join() : ''
    if (stood !== stands && lessonMode.peek() === 'follow') ahead.value = 0
    stood = stands
  })
  effect(() => {
    if (followed.value && !followedPanel.value) stopFollowing()
    else if (wish()) void settle()
  })
}

/** Resolves when what is wanted now is on show. */
export const whenSettled = (): Promise<void> => settling ?? Promise.resolve()

let box: LessonBox | null = null
/** Of which run the worker has a copy. */
let copied: RunSetup | null = null
let settling: Promise<void> | null = null

function settle(): Promise<void> {
  settling ??= goThere()
    .catch(notifyError)
    .finally(() => {
      settling = null
    })
  return settling
}

/** While the copy is on its way, only the newest wish is remembered. */
async function goThere(): Promise<void> {
  let shown = ''
  for (;;) {
    const wanted = untracked(wish)
    const key = wanted ? JSON.stringify({ ...wanted, setup: null }) : ''
    if (!wanted || (key === shown && wanted.setup === copied)) return
    const found = await look(wanted)
    if (!found) continue
    shown = key
    if (isSame(untracked(wish), wanted)) seen.value = found
  }
}

/** Long enough to be quick, short enough to hear of a newer wish. */
const SLICE_MS = 60

/** Null when something else is wanted meanwhile. */
async function look(wanted: Wish): Promise<Seen | null> {
  const worker = await workerFor(wanted.setup)
  const to = wanted.moves + wanted.ahead
  for (;;) {
    const at = await worker.call('followTo', wanted.iteration, to, SLICE_MS)
    if (!isSame(untracked(wish), wanted)) return null
    if (!at.arrived) continue
    const turn = await worker.call('followedAnt', wanted.ant)
    const ants = await worker.call('followedAnts')
    const { panelId, ant } = wanted
    const beyond = Math.max(0, at.moves - wanted.moves)
    return { panelId, ant, at, ahead: beyond, turn, ants, last: lastMove(wanted, at) }
  }
}

async function workerFor(run: RunSetup): Promise<LessonBox> {
  if (box === null || box.dead) {
    box = newLessonBox()
    copied = null
  }
  if (copied !== run) {
    await box.call('followRun', run)
    copied = run
  }
  return box
}

/** What it weighed one move before, if that was on show, and took. */
function lastMove({ panelId, ant }: Wish, at: Followed): AntMove | null {
  const before = seen.peek()
  if (before?.panelId !== panelId || before.ant !== ant) return null
  if (before.at.iteration !== at.iteration) return null
  if (before.at.moves === at.moves) return before.last
  if (before.at.moves + 1 !== at.moves || before.turn?.takes == null) return null
  return before.turn.moves[before.turn.takes] ?? null
}

const isSame = (a: Wish | null, b: Wish) =>
  a !== null &&
  a.setup === b.setup &&
  a.panelId === b.panelId &&
  a.ant === b.ant &&
  a.iteration === b.iteration &&
  a.moves === b.moves &&
  a.ahead === b.ahead

/** The ant nearest to a cell, at most one cell away; null where none is. */
export function antNear([x, y]: readonly [number, number], ants: Int32Array): number | null {
  let nearest: { ant: number; away: number } | null = null
  for (let ant = 0; 2 * ant < ants.length; ant++) {
    const [atX = -1, atY = -1] = ants.subarray(2 * ant)
    const away = Math.max(Math.abs(atX - x), Math.abs(atY - y))
    if (atX >= 0 && away <= 1 && away < (nearest?.away ?? 2)) nearest = { ant, away }
  }
  return nearest?.ant ?? null
}
