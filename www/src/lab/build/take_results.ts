/** Files of imported results find their place: in the open comparison, or in the one that is being put together. */
import { tools } from '../../engine/tools'
import type { ImportedFile } from '../../model/draft'
import { joinResults, phase } from '../run/actions'
import { addImportedFile, refusedFile } from '../store/imported_files'
import { compose } from './compose'

/** Joins a file to the open comparison or, where none is open, to the one that is being put together. */
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

/** What does not fit is refused now, not when the runs are to start. */
async function addToDraft(file: Omit<ImportedFile, 'key'>): Promise<void> {
  await tools.joinResults(await compose(), file.bytes, file.name, file.instance)
  addImportedFile(file)
}
