import { guide } from '../state'
import { names } from '../state/lazy_parts'

/** Where the title and the note of the race stand, if it has any: those of a lesson are on its card. */
export function NotePlace() {
  const part = names.value
  return part && guide.value === null && <part.NoteStrip />
}
