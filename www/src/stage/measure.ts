/** What a stage needs to know of its element, and how often it tells its worker. */
import { effect } from '@preact/signals'
import type { CanvasSize } from './panel_view'

/** Reports the element's size in device pixels, now and whenever it or the pixel ratio changes. */
export function measure(element: HTMLElement, report: (size: CanvasSize) => void): () => void {
  const read = () => {
    const dpr = devicePixelRatio
    const width = Math.max(1, Math.round(element.clientWidth * dpr))
    const height = Math.max(1, Math.round(element.clientHeight * dpr))
    report({ width, height, dpr })
  }
  const observer = new ResizeObserver(read)
  observer.observe(element)
  const stopWatching = watchPixelRatio(read)
  read()
  return () => {
    observer.disconnect()
    stopWatching()
  }
}

/** A media query answers for one ratio only, so it is asked anew after each change. */
function watchPixelRatio(report: () => void): () => void {
  let query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`)
  const changed = () => {
    query.removeEventListener('change', changed)
    query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`)
    query.addEventListener('change', changed)
    report()
  }
  query.addEventListener('change', changed)
  return () => query.removeEventListener('change', changed)
}

/** Sends what `read` gives at once, then once a frame at most while the signals it reads change. */
export function coalesced<T>(read: () => T, send: (value: T) => void): () => void {
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
