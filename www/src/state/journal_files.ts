/** Journals of a comparison's runs, and files with more runs than the page takes. */
import type { EngineError } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { showView } from '.'
import { bytesOf, MAX_BYTES } from './file_bytes'
import { lazyParts } from './lazy_parts'

/** How the name of a journal ends. */
const ENDING = '.journal'
/** Bytes by which a file is recognised. */
const ENOUGH_TO_KNOW = 64 * 1024

/** Whether all of them are journals, by their names: one that has another name is recognised as any other file. */
export const areJournals = (files: File[]): boolean =>
  files.length > 0 && files.every(({ name }) => name.endsWith(ENDING))

/**
 * Takes their runs into the comparison that is open. Whoever collects them drops the next while one is read, so none ends the opening of
 * another.
 */
export async function takeInJournals(files: File[]): Promise<void> {
  const { takeJournalFiles } = await lazyParts.lab()
  showView('lab')
  await takeJournalFiles(files.map((file) => ({ name: file.name, read: () => contentOf(file) })))
}

/** What a file holds. A comparison or journal that is too large is refused unread, with the way that takes it. */
export async function contentOf(file: File): Promise<Uint8Array> {
  await refuseTooManyRuns(file)
  return bytesOf(file)
}

/** Throws where a comparison or a journal is too large, by its beginning alone; who has so many runs is helped by the command line. */
async function refuseTooManyRuns(file: File): Promise<void> {
  if (file.size <= MAX_BYTES) return
  const begins = new Uint8Array(await file.slice(0, ENOUGH_TO_KNOW).arrayBuffer())
  const { kind } = await tools.recognise(begins, file.name)
  if (kind !== 'comparison' && kind !== 'journal') return
  throw tooManyRuns(file, kind)
}

function tooManyRuns({ name, size }: File, kind: 'comparison' | 'journal'): EngineError {
  const inMiB = (bytes: number) => Math.ceil(bytes / 2 ** 20)
  const message = t('opening.tooManyRuns', { name, size: inMiB(size) })
  const hint = t(`opening.tooManyRunsHint.${kind}`, { most: inMiB(MAX_BYTES), file: name })
  return { kind: 'too-many-runs', field: name, message, hint, args: {} }
}
