/** Which half of the page is on show: the race, or the laboratory. Kept through a reload, like the session. */
import { signal } from '@preact/signals'
import { pause, play } from './runs'
import { phase } from './store'

export type PageView = 'race' | 'lab'

const KEY = 'formicarium.view'
const HASH = '#lab'

export const view = signal<PageView>(first())

/** Whether the race was playing when the reader left for the laboratory: it goes on when they come back. */
let interrupted = false

/** Plays now, or once the race is on show again. */
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
  // An address of the other view is dropped, or a reload would show that view again.
  const fits = isAboutLab(location.hash) === (next === 'lab')
  if (!fits)
    history.replaceState(null, '', next === 'lab' ? HASH : location.pathname + location.search)
  remember(next)
}

/** An address with a comparison shows the laboratory, one with a session the race. */
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
