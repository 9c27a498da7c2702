/**
 * Parts of the page that stand above the state and are fetched when they are first asked for. What the state and the stage need of
 * them is written here; app/lazy_parts.ts says where they are.
 */

import { type ReadonlySignal, type Signal, signal } from '@preact/signals'
import type { IconNode } from 'lucide'
import type { ComponentType } from 'preact'
import type { Cell } from '../model/cell'
import type { PanelSetup, Scenario } from '../model/session'
import type { Press, Stroke } from '../model/stroke'
import type { ToldByLink } from '../share/comparison_link'
import type { Arrival } from './address'
import type { UnreadFile } from './file_bytes'
import type { Tool } from './store'

/** Comparisons (lab/). */
export interface LabPart {
  /** Opens the text of a comparison file. */
  openComparisonDocument(text: string, told?: ToldByLink): Promise<void>
  /** Takes in a file of imported results. */
  takeImportedResults(name: string, bytes: Uint8Array): Promise<void>
  /** Takes the runs of journals into the comparison that is open, or says which one they need. */
  takeJournalFiles(files: UnreadFile[]): Promise<void>
  /** Shows what the papers ask. */
  showPublished(): Promise<void>
  /** Explains the open comparison to somebody who was sent it. */
  AboutComparison: ComponentType
}

/** Terrains in three dimensions (relief/). */
export interface ReliefPart {
  ReliefStage: ComponentType<{ panelId: number }>
  zoomEye(factor: number): void
  resetEye(): void
}

/** Tools that draw more than one cell after the other, or take up a part of the map (editor/). */
export interface EditorPart {
  /** What a press does; null where the tool in hand is the page's own. */
  begin(press: Press): Stroke | null
  /** A key on a focused map; true when the tool in hand has handled it. */
  key(event: KeyboardEvent, cursor: Signal<{ cell: Cell; byKeys: boolean } | null>): boolean
  /** A key of the page that chooses a tool or the size of the brush. */
  shortcut(key: string): void
  /** Lists the tools that draw walls as soon as it is there. */
  openShapes(): void
  /** What the button for walls shows: the one of its tools used last. */
  wallTool: ReadonlySignal<{ id: Tool; icon: IconNode; keys: string; label: string }>
  /** The rest of the tools, in the place that the row keeps for them. */
  MoreTools: ComponentType
  /** Drawn over a map: what a press would do. Its properties are the stage's. */
  // biome-ignore lint/suspicious/noExplicitAny: the stage that mounts it knows them
  EditPreview: ComponentType<any>
}

/** Opens files and texts (state/open_files.ts); false where not all was opened, and the reader knows. */
export interface OpenerPart {
  openText(text: string, opening?: { unasked?: boolean }): Promise<boolean>
  openFiles(files: File[]): Promise<boolean>
  /** Opens files as maps, and hands each of them to `take` instead of the race. */
  openMapsFor(files: File[], take: (opened: Scenario) => void): Promise<void>
  openDropped(files: File[], entries: FileSystemEntry[]): Promise<boolean>
}

/** Names, notes and what a link looked at (panels/names.ts). */
export interface NamesPart {
  /** The name of a panel, which can be changed. */
  PanelName: ComponentType<{ panelId: number; place: number }>
  NoteStrip: ComponentType
  /** What tells one from the others: of equal planners what differs; empty where nothing has to be told. */
  markOf(one: Named, all: readonly Named[]): string
  /** The key of the built-in map that has this name in its file; undefined for any other name. */
  builtInCalled(name: string): string | undefined
}

/** A planner with its values, and what the reader calls it. */
export type Named = Pick<PanelSetup, 'planner' | 'preset' | 'params' | 'label'>

/** Back and Forward between the sessions that links brought (state/left_sessions.ts). */
export interface LeftSessionsPart {
  changeSession(arrival: Arrival): Promise<void>
}

/** At the transport · on a panel's map · the card of what is being done · the target in one line · its field in the share dialog. */
export type LessonPiece = 'tools' | 'map' | 'cards' | 'target' | 'field'

export interface LazyParts {
  /** Has walls change while planners run (state/changing_walls.ts). */
  walls(): Promise<unknown>
  opener(): Promise<OpenerPart>
  leftSessions(): Promise<LeftSessionsPart>
  lab(): Promise<LabPart>
  relief(): Promise<ReliefPart>
  names(): Promise<NamesPart>
  editor(): Promise<EditorPart>
  /** What a cell tells about the moves of an ant (playback/); its properties are the stage's. */
  // biome-ignore lint/suspicious/noExplicitAny: the stage that mounts it knows them
  inspector(): Promise<ComponentType<any>>
  /** A piece of a lesson (lesson/), with the properties that its place gives it. */
  // biome-ignore lint/suspicious/noExplicitAny: whoever mounts it knows them
  lesson(piece: LessonPiece): Promise<ComponentType<any>>
}

const missing = () => Promise.reject(new Error('the parts of the page have not been named yet'))

/** Where to fetch them. */
export const lazyParts: LazyParts = {
  walls: missing,
  opener: missing,
  leftSessions: missing,
  lab: missing,
  relief: missing,
  names: missing,
  editor: missing,
  inspector: missing,
  lesson: missing,
}

/** Called once, before the page is drawn. */
export function nameLazyParts(parts: LazyParts): void {
  Object.assign(lazyParts, parts)
}

/** Null until it is here: once the browser is idle, or with the first session that has more to say than its race. */
export const names = signal<NamesPart | null>(null)

export async function fetchNames(): Promise<void> {
  names.value ??= await lazyParts.names()
}
