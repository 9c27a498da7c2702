/** The one way in for bytes of files: a size is refused by what the browser tells of it, before anything is read. */
import type { EngineError } from '@pkg/formicarium'
import { t } from '../i18n/dialogs'

/** Larger files and pasted texts are refused. */
export const MAX_BYTES = 64 * 1024 * 1024

/** A file that is read once it is its turn; what is refused then is thrown. */
export interface UnreadFile {
  name: string
  read(): Promise<Uint8Array>
}

/** What a file holds; throws, without reading it, where it is too large. */
export async function bytesOf(file: File): Promise<Uint8Array<ArrayBuffer>> {
  refuseLarge(file.size, file.name)
  return new Uint8Array(await file.arrayBuffer())
}

/** Throws where so many bytes, or characters of a text, are too many. */
export function refuseLarge(size: number, name: string): void {
  if (size > MAX_BYTES) throw tooLarge(name)
}

function tooLarge(name: string): EngineError {
  const message = t('opening.tooLarge', { name })
  const hint = t('opening.tooLargeHint')
  return { kind: 'file-too-large', field: name, message, hint, args: {} }
}
