/** Pointer events of a stage, from above or in three dimensions. */

export interface PointerHandlers {
  pointerdown(event: PointerEvent): void
  pointermove(event: PointerEvent): void
  pointerup(event: PointerEvent): void
  pointercancel(event: PointerEvent): void
  pointerleave(event: PointerEvent): void
  dblclick(event: MouseEvent): void
  contextmenu?(event: MouseEvent): void
  wheel(event: WheelEvent): void
}

/** Listens until `signal` ends it. The wheel may be kept from scrolling the page. */
export function listenToPointers(
  element: HTMLElement,
  handlers: PointerHandlers,
  signal: AbortSignal,
): void {
  for (const [kind, handle] of Object.entries(handlers)) {
    const options = kind === 'wheel' ? { signal, passive: false } : { signal }
    element.addEventListener(kind, handle as EventListener, options)
  }
}

/** A wheel over the whole map scrolls the page, as it does beside the map; browsers report a pinched touchpad as Ctrl and wheel. */
export function wheelZooms({ ctrlKey, metaKey }: WheelEvent, zoom: number): boolean {
  return ctrlKey || metaKey || zoom > 1
}
