/** Sessions that the reader left by a link in the address: Back brings them back as they were left. */
import { batch } from '@preact/signals'
import type { Session } from '../model/session'
import { currentSession, loadSession, openFragment } from '.'
import { type Arrival, staysAt } from './address'
import { guide, LESSON_PREFIX } from './lesson'
import { autoplay } from './sessions'

const left = new Map<number, Session>()
let changing: Promise<void> = Promise.resolve()

/** Shows the session of the entry that was come to, and keeps the one that was left; one change after the other. */
export function changeSession(arrival: Arrival): Promise<void> {
  const change = changing.then(() => changeNow(arrival))
  changing = change.catch(() => {})
  return change
}

async function changeNow({ from, to }: Arrival): Promise<void> {
  const before = currentSession()
  const kept = left.get(to)
  if (kept) loadAgain(kept)
  // What could not be opened leaves the session that is on show.
  else if (!(await openFragment(location.hash))) return staysAt(from)
  if (before) left.set(from, before)
  autoplay()
}

/** A lesson of the gallery with its card. */
function loadAgain(session: Session): void {
  const { hash } = location
  batch(() => {
    loadSession(session)
    if (hash.startsWith(LESSON_PREFIX)) guide.value = hash.slice(LESSON_PREFIX.length)
  })
}
