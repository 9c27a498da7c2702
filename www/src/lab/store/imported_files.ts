/** Imported results: files of runs from elsewhere, to be compared with the runs done here. */
import type { MatchedMap, ResultsMatch } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { lateTools } from '../../engine/late_tools'
import type { ImportedFile } from '../../model/draft'
import { isEngineError } from '../../model/errors'

/** A file whose results could not be joined. */
export interface RefusedFile {
  key: number
  name: string
  bytes: Uint8Array
  error: unknown
  /** Whose runs it holds, and on which maps; null where it could not be read. */
  match: ResultsMatch | null
}

export const importedFiles = signal<ImportedFile[]>([])
/** Files that are not joined, each until the reader deals with it. */
export const refusedFiles = signal<RefusedFile[]>([])

let nextKey = 1

export function addImportedFile(file: Omit<ImportedFile, 'key'>): void {
  importedFiles.value = [...importedFiles.peek(), { ...file, key: nextKey++ }]
}

export function removeImportedFile(key: number): void {
  importedFiles.value = importedFiles.peek().filter((file) => file.key !== key)
}

/** In place of the one with the same key, or last. */
export function addRefusedFile(file: Omit<RefusedFile, 'key'>, key = nextKey++): void {
  const before = refusedFiles.peek()
  const isThere = before.some((other) => other.key === key)
  const refused = { ...file, key }
  refusedFiles.value = isThere
    ? before.map((other) => (other.key === key ? refused : other))
    : [...before, refused]
}

export function removeRefusedFile(key: number): void {
  refusedFiles.value = refusedFiles.peek().filter((file) => file.key !== key)
}

/** Files of a stored draft. */
export function takeImportedFiles(files: Omit<ImportedFile, 'key'>[]): void {
  const told = { leaveOut: [], match: null }
  importedFiles.value = files.map((file) => ({ ...told, ...file, key: nextKey++ }))
}

/** Whether nothing is wrong with the file but the names of its maps. */
const isAboutMaps = ({ error }: RefusedFile): boolean =>
  isEngineError(error) && error.field === 'results.instance'

/** Whether all its runs are on a single map of which nobody knows which it is here. */
export function asksForMap(file: RefusedFile): boolean {
  const { maps, unnamed } = file.match?.matched ?? { maps: [], unnamed: 0 }
  const names = maps.length + (unnamed > 0 ? 1 : 0)
  return isAboutMaps(file) && names === 1
}

/** The maps in the file that are none here, where others of its maps are. */
export function unknownMaps(file: RefusedFile): MatchedMap[] {
  const { maps, unnamed } = file.match?.matched ?? { maps: [], unnamed: 0 }
  const unknown = maps.filter(({ instance }) => instance === null)
  return isAboutMaps(file) && unknown.length < maps.length && unnamed === 0 ? unknown : []
}

/** The document with the entries of every file. */
export async function withImportedFiles(document: string): Promise<string> {
  let joined = document
  for (const { name, bytes, instance, leaveOut } of importedFiles.peek())
    joined = await lateTools.joinResults(joined, bytes, name, instance, leaveOut)
  return joined
}
