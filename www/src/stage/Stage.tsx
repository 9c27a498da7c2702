/** One panel's map: mounts the worker's canvas, tells it what to show, and turns pointer and keys into edits. */
import { effect, useComputed, useSignal } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import { attach } from '../engine/clients'
import { t } from '../i18n'
import { scenario, tool } from '../state'
import { keyboardHandler } from './keyboard'
import { type CanvasSize, type Cursor, lookAt } from './look'
import { PointerInput } from './pointer'

export function Stage({ panelId }: { panelId: number }) {
  const host = useRef<HTMLDivElement>(null)
  const size = useSignal<CanvasSize>({ width: 1, height: 1, dpr: 1 })
  const cursor = useSignal<Cursor | null>(null)
  const label = useComputed(() => {
    const spec = scenario.value?.spec
    return spec ? t('stage.label', { name: spec.name, width: spec.width, height: spec.height }) : ''
  })

  useEffect(() => {
    const element = host.current
    if (element === null) return
    const client = attach(panelId, element)
    const stopMeasuring = measure(element, (measured) => {
      size.value = measured
    })
    const stopLooking = coalesced(
      () => lookAt(panelId, size.value, cursor.value),
      (view) => client.setView(view),
    )
    const pointer = new PointerInput(element, size, cursor)
    const onKey = keyboardHandler(size, cursor)
    element.addEventListener('keydown', onKey)
    return () => {
      element.removeEventListener('keydown', onKey)
      pointer.release()
      stopLooking()
      stopMeasuring()
    }
  }, [panelId])

  return (
    <div
      ref={host}
      class="stage"
      data-testid={`stage-${panelId}`}
      data-tool={tool.value}
      role="application"
      aria-label={label}
      aria-describedby="stage-help"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: an application region is operated with the keyboard
      tabIndex={0}
    />
  )
}

/** Reports the element's size in device pixels, now and whenever it or the pixel ratio changes. */
function measure(element: HTMLElement, report: (size: CanvasSize) => void): () => void {
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
function coalesced<T>(read: () => T, send: (value: T) => void): () => void {
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
