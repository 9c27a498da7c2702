/** Imports result files into the open comparison, or into the draft. */
import { tools } from '../../engine/tools'
import type { ImportedFile } from '../../model/draft'
import { notifyError } from '../../state'
import { bytesOf } from '../../state/file_bytes'
import { joinResults, phase } from '../run/actions'
import { addImportedFile, refusedFile } from '../store/imported_files'
import { compose } from './compose_document'

/** Joins a file to the open comparison or, where none is open, to the draft. */
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
  for (const file of files) {
    // A file that is refused unread leaves nothing to try again with.
    const bytes = await bytesOf(file).catch(notifyError)
    if (bytes) await takeResults(file.name, bytes)
  }
}

/** A file that does not fit is refused now, rather than when the runs start. */
async function addToDraft(file: Omit<ImportedFile, 'key'>): Promise<void> {
  await tools.joinResults(await compose(), file.bytes, file.name, file.instance)
  addImportedFile(file)
}
