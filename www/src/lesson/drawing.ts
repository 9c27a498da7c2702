/** A path that is drawn piece by piece: each press, drag or key is a piece, and can be taken back. */
import { batch, effect, signal, untracked } from '@preact/signals'
import { type LessonBox, newLessonBox } from '../engine/lesson_box'
import { describeError } from '../i18n/errors'
import { t } from '../i18n/lesson'
import type { Cell } from '../model/cell'
import { sameCell } from '../model/edit'
import type { DrawnPath } from '../model/lesson'
import { MOST_CELLS_DRAWN } from '../model/lesson'
import type { Scenario } from '../model/session'
import { announce, lesson, lessonMode, panels, scenario } from '../state'
import { broughtPath } from '../state/brought_path'
import { changeLesson } from './change_lesson'

/** Where the card is. */
export const drawingOn = signal<number | null>(null)
/** Why the hand could not go there; empty when it could. */
export const refusal = signal('')

type Step = DrawnPath | null
/** The path as it was left here. */
let own: Step = null
const past: Step[] = []
const future: Step[] = []
export const canTakeBack = signal(false)
export const canRedo = signal(false)

export function startDrawing(panelId: number): void {
  // Another session has brought a path of its own.
  if (drawn() !== own) forgetPieces()
  batch(() => {
    drawingOn.value = panelId
    refusal.value = ''
    lessonMode.value = 'draw'
  })
}

/** A path of a file is one piece, whole. */
export function keepTaking(): void {
  effect(() => {
    const path = broughtPath.value
    if (path) untracked(() => take(path))
  })
}

function take(path: DrawnPath): void {
  broughtPath.value = null
  if (drawn() !== own) forgetPieces()
  remember(drawn())
  keep(path)
  startDrawing(panels.peek()[0]?.id ?? 0)
}

export function stopDrawing(): void {
  batch(() => {
    drawingOn.value = null
    lessonMode.value = null
  })
}

export const drawn = (): DrawnPath | null => lesson.peek()?.drawn ?? null

/** The end of the path, from where the hand goes on: at first the start. */
export function handAt(now: Scenario): Cell {
  return drawn()?.path.at(-1) ?? now.spec.start
}

/** A piece is one step back, however many cells it has. */
export interface Piece {
  before: Step
  kept: boolean
}

export const newPiece = (): Piece => ({ before: drawn(), kept: false })

export function takeBack(): void {
  step(past, future)
}

export function redoPiece(): void {
  step(future, past)
}

export function clearDrawn(): void {
  if (!drawn()) return
  remember(drawn())
  keep(null)
  refusal.value = ''
}

export function rename(label: string): void {
  const now = drawn()
  if (now) keep({ ...now, label })
}

function forgetPieces(): void {
  past.length = 0
  future.length = 0
  settled()
}

function step(from: Step[], to: Step[]): void {
  if (from.length === 0) return
  const target = from.pop() ?? null
  to.push(drawn())
  refusal.value = ''
  keep(target)
  settled()
}

function keep(path: Step): void {
  own = path
  changeLesson({ drawn: path })
}

function remember(before: Step): void {
  past.push(before)
  future.length = 0
  settled()
}

function settled(): void {
  canTakeBack.value = past.length > 0
  canRedo.value = future.length > 0
}

let waiting: Promise<void> = Promise.resolve()

/** On to a cell, straight by allowed steps; one after the other, in the order in which they were asked for. */
export function extendTo(cell: Cell, piece: Piece): Promise<void> {
  waiting = waiting.then(() => extend(cell, piece))
  return waiting
}

async function extend(cell: Cell, piece: Piece): Promise<void> {
  const now = scenario.peek()
  if (!now || lessonMode.peek() !== 'draw') return
  const from = handAt(now)
  if (sameCell(from, cell) && drawn()) return
  try {
    const box = await mapBox(now)
    const way = await box.call('drawTowards', from, cell)
    if (scenario.peek() === now && lessonMode.peek() === 'draw') append(now, way, piece)
  } catch (error) {
    const { message, hint } = describeError(error)
    refuse(`${message} ${hint}`)
  }
}

function append(now: Scenario, way: Cell[], piece: Piece): void {
  const before = drawn()
  const path = [...(before?.path ?? [now.spec.start]), ...way]
  if (path.length > MOST_CELLS_DRAWN) {
    refuse(t('lesson.draw.tooLong', { most: MOST_CELLS_DRAWN }))
    return
  }
  if (!piece.kept) remember(piece.before)
  piece.kept = true
  refusal.value = ''
  keep({ label: before?.label ?? t('lesson.draw.byHand'), path })
}

function refuse(why: string): void {
  refusal.value = why
  announce(why)
}

let box: LessonBox | null = null
let on: Scenario | null = null

/** The worker that knows the map. */
export async function mapBox(now: Scenario): Promise<LessonBox> {
  if (box === null || box.dead) {
    box = newLessonBox()
    on = null
  }
  if (on !== now) {
    const { spec, cells, heights, factors } = now
    await box.call('drawOn', spec, cells, heights, factors)
    on = now
  }
  return box
}
