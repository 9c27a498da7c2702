/** Which half of the page is on show, by the address: the race, or the laboratory. */
import { computed, effect, untracked } from '@preact/signals'
import { goTo, place } from './address'
import { pause, play } from './runs'
import { phase } from './store'

export type PageView = 'race' | 'lab'

export const view = computed<PageView>(() =>
  /^#(lab(\/|$)|q=)/.test(place.value) ? 'lab' : 'race',
)

/** Whether the race was playing when the reader left for the laboratory: it goes on when they come back. */
let interrupted = false

/** Plays now, or once the race is on show again. */
export function playWhenShown(): void {
  if (view.peek() === 'race') play()
  else interrupted = true
}

export function showView(next: PageView, how?: 'push' | 'replace'): void {
  if (next !== view.peek()) goTo(next === 'lab' ? '#lab' : '', how)
}

let before = view.peek()
effect(() => {
  const now = view.value
  if (now === before) return
  before = now
  untracked(now === 'lab' ? rest : goOn)
})

function rest(): void {
  interrupted = phase.peek() === 'running'
  pause()
}

function goOn(): void {
  if (interrupted) play()
}
