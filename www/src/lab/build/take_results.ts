/** Imports result files into the open comparison, or into the draft. */
import type { ResultsMatch } from '@pkg/formicarium'
import { lateTools } from '../../engine/late_tools'
import { t } from '../../i18n/lab'
import { notify, notifyError } from '../../state'
import { bytesOf } from '../../state/file_bytes'
import { joinResults, openComparison, phase } from '../run/actions'
import { addImportedFile, addRefusedFile, removeRefusedFile } from '../store/imported_files'
import { compose } from './compose_document'
import { onMap, toldOf } from './match_words'
import { restoreDraft } from './stored_draft'

/** A map of the comparison. */
export interface Place {
  id: string
  name: string
}

/** What the reader says of a file that does not say it. */
export interface Told {
  /** The map on which the runs are. */
  instance?: Place
  /** Names of maps in the file whose runs are left out. */
  leaveOut?: string[]
}

/**
 * Joins a file to the open comparison or, where none is open, to the draft. `key`: of the refused file that the reader has answered;
 * it stays until it is joined.
 */
export async function takeResults(
  name: string,
  bytes: Uint8Array,
  told: Told = {},
  key?: number,
): Promise<void> {
  let match: ResultsMatch | null = null
  const note = (found: ResultsMatch) => {
    match = found
  }
  try {
    await joinFile(name, bytes, told, note)
    if (key !== undefined) removeRefusedFile(key)
  } catch (error) {
    addRefusedFile({ name, bytes, error, match }, key)
  }
}

/** The same, but what is refused is thrown; `note` is told whose runs the file holds before they are joined. */
export async function joinFile(
  name: string,
  bytes: Uint8Array,
  told: Told,
  note: (match: ResultsMatch) => void = () => {},
): Promise<void> {
  const { leaveOut = [] } = told
  const instance = told.instance?.id ?? null
  // The form may never have been on show.
  if (phase.peek() === 'idle') await restoreDraft()
  const document = await documentNow()
  const found = await lateTools.matchResults(document, bytes, name)
  note(found)
  const matched = told.instance ? onMap(found, told.instance.name) : found
  if (phase.peek() === 'idle') {
    // A file that does not fit is refused now, rather than when the runs start.
    await lateTools.joinResults(document, bytes, name, instance, leaveOut)
    addImportedFile({ name, bytes, instance, leaveOut, match: matched })
    return
  }
  if (phase.peek() === 'running') notify('info', t('lab.imported.paused', { name }))
  await joinResults(name, bytes, instance, leaveOut)
  const hint = toldOf(matched, leaveOut).join(' ')
  notify('success', t('lab.imported.joined', { name }), { hint })
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
  return lateTools.resultsTemplate(await documentNow())
}
