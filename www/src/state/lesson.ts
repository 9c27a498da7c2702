/** What the session carries for a lesson, and what the lesson does now. The code for it is fetched when it is first wanted (lesson/). */
import { type ReadonlySignal, signal } from '@preact/signals'
import type { Lesson, MetStop } from '../model/lesson'
import type { Panel } from './store'

/** Null where the session carries nothing. */
export const lesson = signal<Lesson | null>(null)

/** The lesson of the gallery that is on show, by its name; null for any other session. */
export const guide = signal<string | null>(null)

/** What stands before its name in an address of the page. */
export const LESSON_PREFIX = '#lesson='

/** Why the runs stand still; empty while they have another reason. */
export const stopsMet = signal<MetStop[]>([])

/** Somebody wants to run to the end though there are stops, and is to be asked. */
export const askToEnd = signal(false)

/** What the maps are used for instead of their tool: to follow an ant, to guess its moves, to draw a path, to have a robot drive. */
export const lessonMode = signal<'follow' | 'guess' | 'draw' | 'drive' | null>(null)

/** The path by hand as a contestant of the comparison table: a panel that is nowhere on the page, once there is something to compare. */
export const byHand = signal<Panel[]>([])

/** What undo and redo act on, and what their buttons say. */
export interface Undoing {
  canUndo: ReadonlySignal<boolean>
  canRedo: ReadonlySignal<boolean>
  undo(): void
  redo(): void
  words(): { undo: string; redo: string }
}

/** While a path is drawn by hand, undo and redo are the path's everywhere on the page; null: they are the map's. */
export const handUndoing = signal<Undoing | null>(null)
