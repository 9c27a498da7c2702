/** Results from elsewhere: files of runs that are compared with what is run here. */
import { batch, signal } from '@preact/signals'
import { isEngineError } from '../../engine/errors'
import { tools } from '../../engine/tools'
import { compose } from '../build/compose'
import { joinResults, phase } from '../state'

/** A file of somebody's own runs that belongs to the comparison that is being put together. */
export interface OwnFile {
  key: number
  name: string
  bytes: Uint8Array
  /** Id of the map on which they are, where the file does not say. */
  instance: string | null
}

/** A file that cannot be joined as it is. */
export interface RefusedFile {
  name: string
  bytes: Uint8Array
  error: unknown
}

export const ownFiles = signal<OwnFile[]>([])
/** The one that was refused last, until the reader does something about it. */
export const refusedFile = signal<RefusedFile | null>(null)

let nextKey = 1

/** Joins files to the open experiment or, where none is open, to the one that is being put together. */
export async function takeResults(
  name: string,
  bytes: Uint8Array,
  instance: string | null = null,
): Promise<void> {
  refusedFile.value = null
  try {
    if (phase.peek() === 'idle') await addToDraft({ name, bytes, instance })
    else await joinResults(name, bytes, instance)
  } catch (error) {
    refusedFile.value = { name, bytes, error }
  }
}

export async function takeResultFiles(files: Iterable<File>): Promise<void> {
  for (const file of files) await takeResults(file.name, new Uint8Array(await file.arrayBuffer()))
}

export function removeOwnFile(key: number): void {
  ownFiles.value = ownFiles.peek().filter((file) => file.key !== key)
}

/** Files that were taken before. */
export function takeOwnFiles(files: Omit<OwnFile, 'key'>[]): void {
  ownFiles.value = files.map((file) => ({ ...file, key: nextKey++ }))
}

/** Whether all that is missing is on which map the runs are. */
export const asksForMap = ({ error }: RefusedFile): boolean =>
  isEngineError(error) && error.field === 'results.instance'

/** The document with the entries of every file. */
export async function withOwnFiles(document: string): Promise<string> {
  let joined = document
  for (const { name, bytes, instance } of ownFiles.peek())
    joined = await tools.joinResults(joined, bytes, name, instance)
  return joined
}

/** What does not fit is refused now, not when the runs are to start. */
async function addToDraft(file: Omit<OwnFile, 'key'>): Promise<void> {
  await tools.joinResults(await compose(), file.bytes, file.name, file.instance)
  batch(() => {
    ownFiles.value = [...ownFiles.peek(), { ...file, key: nextKey++ }]
  })
}
