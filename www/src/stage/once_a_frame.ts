/** Limits how often a stage tells its worker of changes. */
import { effect } from '@preact/signals'

/** Sends what `read` gives, at once and whenever the signals it reads have changed, at most once a frame. */
export function sendOnceAFrame<T>(read: () => T, send: (value: T) => void): () => void {
  let requested = 0
  let newest = read()
  send(newest)
  const stop = effect(() => {
    newest = read()
    if (requested !== 0) return
    requested = requestAnimationFrame(() => {
      requested = 0
      send(newest)
    })
  })
  return () => {
    stop()
    cancelAnimationFrame(requested)
  }
}
