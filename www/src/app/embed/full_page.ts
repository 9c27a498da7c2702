/** The address at which the session of now, or the comparison, stands in a page of its own. */
import { signal } from '@preact/signals'
import { LinkError } from '../../share/link_error'
import { currentSession, notifyError, view } from '../../state'

const page = location.href.replace(/[?#].*$/s, '')

/** Until it has been asked for, what the frame was opened with. */
export const fullPage = signal(`${page}${location.hash}`)

let turn = 0

/** Makes it anew. */
export function askFullPage(): void {
  const mine = ++turn
  fragmentNow().then(
    (fragment) => {
      if (mine === turn && fragment !== null) fullPage.value = `${page}${fragment}`
    },
    (error) => {
      // Too large for a link: the one that was opened stays.
      if (!(error instanceof LinkError)) notifyError(error)
    },
  )
}

async function fragmentNow(): Promise<string | null> {
  if (view.peek() === 'lab') {
    const { fragmentOfNow } = await import('../../lab')
    return fragmentOfNow()
  }
  const session = currentSession()
  if (!session) return null
  const { encodeSession, PREFIX } = await import('../../share/link')
  return `${PREFIX}${await encodeSession(session)}`
}
