/** Tells of files what they are, and takes archives apart. */
import type { EngineError } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { unpack } from '../engine/unpack'
import { t } from '../i18n/dialogs'
import { isFilm, linkOfFilm } from '../share/film_text'
import { carriedIn } from '../share/page_file'
import { fileName } from './file_paths'
import type { FoundFile, NamedBytes } from './offered_files'

/** A picture, a film or a page of ours, by the session or comparison in it. */
export interface Carrier extends NamedBytes {
  kind: 'carrier'
  text: string
}

/** `<`, with which a page begins. */
const OPENS_TAG = 60

export interface Looked {
  found: (FoundFile | Carrier)[]
  refused: unknown[]
  /** Archives within archives. */
  nested: EngineError[]
  /** They lay in a folder or archive: what cannot be opened is passed over. */
  loose: boolean
}

/** Looks at files that came together. */
export async function lookAt(given: NamedBytes[], loose = false): Promise<Looked> {
  const looked: Looked = { found: [], refused: [], nested: [], loose }
  for (const file of given) await look(file, looked, null)
  return looked
}

/** `archive`: the one in which it lies; null where it lies in none. */
async function look(file: NamedBytes, looked: Looked, archive: string | null): Promise<void> {
  try {
    const { name, bytes } = file
    const text = await carriedBy(bytes)
    if (text !== null) {
      looked.found.push({ name, bytes, kind: 'carrier', text })
      return
    }
    const recognised = await tools.recognise(bytes, name)
    if (recognised.kind !== 'archive') looked.found.push({ ...recognised, name, bytes })
    else if (archive !== null) looked.nested.push(archiveWithin(fileName(name), archive))
    else {
      const within = await unpack(bytes, name)
      // A single file in an archive is meant, whatever it is.
      if (within.length > 1) looked.loose = true
      for (const one of within) await look(one, looked, fileName(name))
    }
  } catch (error) {
    looked.refused.push(error)
  }
}

function archiveWithin(inner: string, archive: string): EngineError {
  const message = t('opening.archiveWithin', { inner, archive })
  const hint = t('opening.archiveWithinHint')
  return { kind: 'archive-within', field: inner, message, hint, args: {} }
}

/** The session or comparison in a PNG, a film or a page of ours; null for any other file. */
async function carriedBy(bytes: Uint8Array): Promise<string | null> {
  if (isFilm(bytes)) return linkOfFilm(bytes)
  if (bytes[0] === OPENS_TAG) return carriedIn(new TextDecoder().decode(bytes))
  if (bytes[0] !== 137 || bytes[1] !== 80) return null
  const { textOfPng } = await import('../share/png')
  return textOfPng(bytes).catch((error: { kind?: string }) => {
    if (error.kind === 'picture-bare') return null
    throw error
  })
}

const OPENED = new Set([
  'carrier',
  'session',
  'comparison',
  'journal',
  'results',
  'movingai-scen',
  'tsplib',
  'tsplib-tour',
  'path',
])
export const canBeOpened = (file: FoundFile | Carrier) =>
  OPENED.has(file.kind) || (file.kind !== 'carrier' && file.map)
