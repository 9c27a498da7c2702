/** The size of an element in device pixels. */
import type { CanvasSize } from './panel_view'

/** Reports the element's size in device pixels, as soon as it has been laid out and whenever it or the pixel ratio changes. */
export function watchSize(element: HTMLElement, report: (size: CanvasSize) => void): () => void {
  const read = () => {
    const dpr = devicePixelRatio
    const width = Math.max(1, Math.round(element.clientWidth * dpr))
    const height = Math.max(1, Math.round(element.clientHeight * dpr))
    report({ width, height, dpr })
  }
  const observer = new ResizeObserver(read)
  observer.observe(element)
  const stopWatching = watchPixelRatio(read)
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
