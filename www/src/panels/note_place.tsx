import { names } from '../state/lazy_parts'

/** Where the title and the note of the race stand, if it has any. */
export function NotePlace() {
  const part = names.value
  return part && <part.NoteStrip />
}
