/**
 * Where on the page the reader is: the only file that writes to the browser's history. Watch has no fragment, or that of the link that
 * was opened (`#x=…`, `#lesson=…`); Compare is `#lab`, a comparison `#lab/<id>/<tab>` and, until it has been opened, `#q=…`. In another
 * page it writes nothing: Back would go through the frame first.
 */
import { signal } from '@preact/signals'
import { embedding } from './embedding'

/** What an entry of the browser's history remembers. */
interface Entry {
  /** Its place among the page's entries. */
  at: number
  /** The session that was on show: each link that is written into the address begins another one. */
  session: number
}

/** A link whose signs a program has written as codes: then it may stand in the path or the query, and nowhere behind a `#`. */
const CODED = /(?:#|%(?:25)*23)([xq])(?:=|%(?:25)*3d)/i

/** The rest of the page finds the link where it belongs. */
function uncode(): void {
  const { href, hash } = location
  const found = /^#[xq]=/.test(hash) ? null : CODED.exec(href)
  if (!found) return
  let at = found.index
  while ('?&#'.includes(href[at - 1] ?? '-')) at--
  const link = `#${found[1]}=${href.slice(found.index + found[0].length)}`
  history.replaceState(history.state, '', href.slice(0, at) + link)
}
uncode()

const known = embedding ? null : (history.state as Entry | null)
/** The fragment with which the page was loaded, if the reader had been at that entry before: a reload, or Back from another site. */
export const returnedTo = known && location.hash
let entry: Entry = known ?? { at: 0, session: 0 }

/** The fragment of the address. */
export const place = signal(location.hash)

/** What the reader did with the address itself: went back or forward, or wrote a link into it. */
export interface Arrival {
  /** The sessions left and come to; another one where the link is new, or belongs to another entry. */
  from: number
  to: number
}
export const arrival = signal<Arrival | null>(null)

/** Goes to a place of the page; `replace` where the reader should not come back to the one that is left. */
export function goTo(fragment: string, how: 'push' | 'replace' = 'push'): void {
  const pushes = how === 'push' && fragment !== location.hash
  if (pushes) entry = { ...entry, at: entry.at + 1 }
  if (!embedding)
    history[pushes ? 'pushState' : 'replaceState'](
      entry,
      '',
      fragment || location.href.replace(/#.*$/, ''),
    )
  place.value = fragment
}

/** The entry belongs to this session after all. */
export function staysAt(session: number): void {
  entry = { ...entry, session }
  remember()
}

staysAt(entry.session)

addEventListener('popstate', ({ state }) => {
  // A link written into the address has no state yet: see below.
  if (!state) return
  const aside = entry.at - state.at
  const dialog = document.querySelector<HTMLDialogElement>('dialog[open]')
  if (dialog && aside !== 0) {
    // Back closes a dialog and leaves the page where it was.
    dialog.close()
    history.go(aside)
  } else arrive(state)
})

addEventListener('hashchange', () => {
  if (history.state) return
  uncode()
  const isSession = /^#(x|lesson)=/.test(location.hash)
  arrive({ at: entry.at + 1, session: isSession ? Date.now() : entry.session })
  remember()
})

function remember(): void {
  if (!embedding) history.replaceState(entry, '')
}

function arrive(next: Entry): void {
  const from = entry.session
  entry = next
  // First: who follows the address must know that it was the reader who changed it.
  arrival.value = { from, to: next.session }
  place.value = location.hash
}
