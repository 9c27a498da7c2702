/** Imports result files into the open comparison, or into the draft. */
import type { ResultsMatch } from '@pkg/formicarium'
import { tools } from '../../engine/tools'
import { t } from '../../i18n/lab'
import { notify, notifyError } from '../../state'
import { bytesOf } from '../../state/file_bytes'
import { joinResults, openComparison, phase } from '../run/actions'
import { addImportedFile, refusedFile } from '../store/imported_files'
import { compose } from './compose_document'
import { toldOf } from './match_words'
import { restoreDraft } from './stored_draft'

/** What the reader says of a file that does not say it. */
export interface Told {
  /** Id of the map on which the runs are. */
  instance?: string
  /** Names of maps in the file whose runs are left out. */
  leaveOut?: string[]
}

/** Joins a file to the open comparison or, where none is open, to the draft. */
export async function takeResults(name: string, bytes: Uint8Array, told: Told = {}): Promise<void> {
  const { instance = null, leaveOut = [] } = told
  refusedFile.value = null
  let match: ResultsMatch | null = null
  try {
    // The form may never have been on show.
    if (phase.peek() === 'idle') await restoreDraft()
    const document = await documentNow()
    const found = await tools.matchResults(document, bytes, name)
    match = found
    if (phase.peek() === 'idle') {
      // A file that does not fit is refused now, rather than when the runs start.
      await tools.joinResults(document, bytes, name, instance, leaveOut)
      addImportedFile({ name, bytes, instance, leaveOut, match: found })
    } else {
      await joinResults(name, bytes, instance, leaveOut)
      const hint = toldOf(found, leaveOut).join(' ')
      notify('success', t('lab.imported.joined', { name }), { hint })
    }
  } catch (error) {
    refusedFile.value = { name, bytes, error, match }
  }
}

/** The open comparison or, where none is open, the draft. */
const documentNow = async () => openComparison.peek()?.document ?? (await compose())

export async function takeResultFiles(files: Iterable<File>): Promise<void> {
  for (const file of files) {
    // A file that is refused unread leaves nothing to try again with.
    const bytes = await bytesOf(file).catch(notifyError)
    if (bytes) await takeResults(file.name, bytes)
  }
}

/** An empty table for the maps and seeds of the open comparison, or of the draft. */
export async function resultsTemplate(): Promise<string> {
  return tools.resultsTemplate(await documentNow())
}
