/** The files in folders that were dropped. */
import type { EngineError } from '@pkg/formicarium'
import { t } from '../i18n/dialogs'

/** Of a folder no more files are looked at. */
const MAX_FILES = 1000

/** Every file in these folders and those within, but hidden ones, with its path. Rejects where there are too many. */
export async function filesWithin(
  entries: FileSystemEntry[],
): Promise<{ path: string; file: File }[]> {
  const found: { path: string; file: File }[] = []
  const waiting = [...entries]
  for (let entry = waiting.shift(); entry; entry = waiting.shift()) {
    if (entry.name.startsWith('.')) continue
    if (entry.isDirectory) waiting.push(...(await listed(entry as FileSystemDirectoryEntry)))
    else {
      if (found.length === MAX_FILES) throw tooMany(entry.name)
      found.push({ path: entry.fullPath, file: await fileOf(entry as FileSystemFileEntry) })
    }
  }
  return found
}

const fileOf = (entry: FileSystemFileEntry) =>
  new Promise<File>((resolve, reject) => entry.file(resolve, reject))

/** A reader gives a hundred at a time. */
async function listed(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader()
  const all: FileSystemEntry[] = []
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    )
    if (some.length === 0 || all.length > MAX_FILES) return all
    all.push(...some)
  }
}

function tooMany(name: string): EngineError {
  const message = t('opening.tooManyFiles', { most: MAX_FILES })
  return {
    kind: 'too-many-files',
    field: name,
    message,
    hint: t('opening.tooManyFilesHint'),
    args: {},
  }
}
