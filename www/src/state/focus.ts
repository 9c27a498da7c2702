/** One panel alone on the page, with larger type: for projectors and films. */
import { computed, signal } from '@preact/signals'
import { panelById, panels, selectedPanel } from './store'

const wanted = signal<number | null>(null)

/** The panel that has the page to itself; null for all of them. */
export const focused = computed(() => {
  const id = wanted.value
  return id !== null && panels.value.some((panel) => panel.id === id) ? id : null
})

export function focusOn(panelId: number): void {
  wanted.value = panelId
}

/** True when a panel had the page to itself. */
export function leaveFocus(): boolean {
  const had = focused.peek() !== null
  wanted.value = null
  if (had && document.fullscreenElement) void document.exitFullscreen()
  return had
}

/** The panel whose parameters are on show, or the first one. */
export function toggleFocus(): void {
  if (leaveFocus()) return
  wanted.value = panelById(selectedPanel.peek() ?? -1)?.id ?? panels.peek()[0]?.id ?? null
}

/** Where the browser can; elsewhere nothing happens. */
export function toggleFullScreen(): void {
  if (document.fullscreenElement) void document.exitFullscreen()
  else document.documentElement.requestFullscreen?.().catch(() => {})
}
