import { caption } from '../state'
import { lazily } from '../ui/lazily'

const NoteStrip = lazily(async () => (await import('./note_strip')).fetchNoteStrip())

/** Where the title and the note of the race stand, if it has any. */
export function NotePlace() {
  return caption.value.title || caption.value.note ? <NoteStrip /> : null
}
