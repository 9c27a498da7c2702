/**
 * Parts of the page that stand above the state and are fetched when they are first asked for. What the state and the stage need of
 * them is written here; app/lazy_parts.ts says where they are.
 */
import type { ComponentType } from 'preact'
import type { Scenario } from '../model/session'

/** Comparisons (lab/). */
export interface LabPart {
  /** Opens the text of a comparison file. */
  openComparisonDocument(text: string): Promise<void>
  /** Takes in a file of imported results. */
  takeImportedResults(name: string, bytes: Uint8Array): Promise<void>
  /** Shows what the papers ask. */
  showPublished(): Promise<void>
}

/** Terrains in three dimensions (relief/). */
export interface ReliefPart {
  ReliefStage: ComponentType<{ panelId: number }>
  zoomEye(factor: number): void
  resetEye(): void
}

/** Opens files and texts (state/open_files.ts); false where not all was opened, and the reader knows. */
export interface OpenerPart {
  openText(text: string, opening?: { unasked?: boolean }): Promise<boolean>
  openFiles(files: File[]): Promise<boolean>
  /** Opens files as maps, and hands each of them to `take` instead of the race. */
  openMapsFor(files: File[], take: (opened: Scenario) => void): Promise<void>
  openDropped(files: File[], entries: FileSystemEntry[]): Promise<boolean>
}

export interface LazyParts {
  /** Has walls change while planners run (state/changing_walls.ts). */
  walls(): Promise<unknown>
  opener(): Promise<OpenerPart>
  lab(): Promise<LabPart>
  relief(): Promise<ReliefPart>
  /** What a cell tells about the moves of an ant (playback/); its properties are the stage's. */
  // biome-ignore lint/suspicious/noExplicitAny: the stage that mounts it knows them
  inspector(): Promise<ComponentType<any>>
}

const missing = () => Promise.reject(new Error('the parts of the page have not been named yet'))

/** Where to fetch them. */
export const lazyParts: LazyParts = {
  walls: missing,
  opener: missing,
  lab: missing,
  relief: missing,
  inspector: missing,
}

/** Called once, before the page is drawn. */
export function nameLazyParts(parts: LazyParts): void {
  Object.assign(lazyParts, parts)
}
