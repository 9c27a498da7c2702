/** Imported results: files of runs from elsewhere, to be compared with the runs done here. */
import { signal } from '@preact/signals'
import { tools } from '../../engine/tools'
import type { ImportedFile } from '../../model/draft'
import { isEngineError } from '../../model/errors'

/** A file whose results could not be joined. */
export interface RefusedFile {
  name: string
  bytes: Uint8Array
  error: unknown
}

export const importedFiles = signal<ImportedFile[]>([])
/** The file that was refused last, until the reader deals with it. */
export const refusedFile = signal<RefusedFile | null>(null)

let nextKey = 1

export function addImportedFile(file: Omit<ImportedFile, 'key'>): void {
  importedFiles.value = [...importedFiles.peek(), { ...file, key: nextKey++ }]
}

export function removeImportedFile(key: number): void {
  importedFiles.value = importedFiles.peek().filter((file) => file.key !== key)
}

/** Files of a stored draft. */
export function takeImportedFiles(files: Omit<ImportedFile, 'key'>[]): void {
  importedFiles.value = files.map((file) => ({ ...file, key: nextKey++ }))
}

/** Whether the file was refused only because it does not name its map. */
export const asksForMap = ({ error }: RefusedFile): boolean =>
  isEngineError(error) && error.field === 'results.instance'

/** The document with the entries of every file. */
export async function withImportedFiles(document: string): Promise<string> {
  let joined = document
  for (const { name, bytes, instance } of importedFiles.peek())
    joined = await tools.joinResults(joined, bytes, name, instance)
  return joined
}
