/** What the page is about now: watching a few runs, or comparing many of them. Kept through a reload, with the session. */
import { signal } from '@preact/signals'
import { pause, play } from './runs'
import { phase } from './store'

export type PageView = 'race' | 'lab'

const KEY = 'formicarium.view'
const HASH = '#lab'

export const view = signal<PageView>(first())

/** Whether the runs on show were playing when the reader went to compare: then they go on afterwards. */
let interrupted = false

/** What would play plays once it is shown. */
export function playWhenShown(): void {
  if (view.peek() === 'race') play()
  else interrupted = true
}

export function showView(next: PageView): void {
  if (next === view.peek()) return
  if (next === 'lab') {
    interrupted = phase.peek() === 'running'
    pause()
  } else if (interrupted) play()
  view.value = next
  // An address of the other view is left behind, or a reload would bring that one back.
  const fits = isAboutLab(location.hash) === (next === 'lab')
  if (!fits)
    history.replaceState(null, '', next === 'lab' ? HASH : location.pathname + location.search)
  remember(next)
}

/** An address that is about experiments shows them, one with a session shows that. */
export function followAddress(): void {
  if (location.hash !== '') showView(isAboutLab(location.hash) ? 'lab' : 'race')
}

function isAboutLab(hash: string): boolean {
  return hash === HASH || hash.startsWith('#q=')
}

function first(): PageView {
  if (location.hash !== '') return isAboutLab(location.hash) ? 'lab' : 'race'
  try {
    return sessionStorage.getItem(KEY) === 'lab' ? 'lab' : 'race'
  } catch {
    return 'race'
  }
}

/** Private windows may refuse storage. */
function remember(shown: PageView): void {
  try {
    if (shown === 'lab') sessionStorage.setItem(KEY, shown)
    else sessionStorage.removeItem(KEY)
  } catch {}
}
