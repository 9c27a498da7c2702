/** While a lesson uses the maps, pointer and Enter are its own; everything else stays the map's: wheel, zoom, the cell cursor. */
import type { ReadonlySignal } from '@preact/signals'
import type { Cell } from '../model/cell'
import { isInside } from '../model/edit'
import { toMap } from '../model/viewpoint'
import { type CanvasSize, type Cursor, place } from '../stage/panel_view'
import { lessonMode, scenario } from '../state'

export interface MapHandlers {
  /** A press begins; further cells follow while it is held. */
  press(cell: Cell): void
  drag?(cell: Cell): void
  release?(): void
  /** Enter at the cell cursor. */
  enter(cell: Cell): void
  /** Any other key; true when it was used. */
  key?(event: KeyboardEvent): boolean
}

/** Listens on what holds the map, before the map itself does; returns what ends it. */
export function listenToMap(
  holder: HTMLElement,
  size: ReadonlySignal<CanvasSize>,
  cursor: ReadonlySignal<Cursor | null>,
  handlers: () => MapHandlers | null,
): () => void {
  const listening = new AbortController()
  const options = { capture: true, signal: listening.signal }
  let held: number | null = null
  let last: Cell | null = null

  const cellOf = (event: PointerEvent): Cell | null => {
    const map = event.target instanceof Element ? event.target.closest('.stage') : null
    const now = scenario.peek()
    if (!map || !now) return null
    const box = map.getBoundingClientRect()
    const { dpr } = size.peek()
    const at: [number, number] = [(event.clientX - box.left) * dpr, (event.clientY - box.top) * dpr]
    const [x, y] = toMap(place(size.peek()), at)
    const cell: Cell = [Math.floor(x), Math.floor(y)]
    return isInside(now, cell) ? cell : null
  }
  const take = (event: Event) => {
    event.preventDefault()
    event.stopPropagation()
  }

  holder.addEventListener(
    'pointerdown',
    (event) => {
      const used = handlers()
      const map = event.target instanceof Element ? event.target.closest('.stage') : null
      if (!used || !(map instanceof HTMLElement) || event.button !== 0 || held !== null) return
      const cell = cellOf(event)
      take(event)
      // Keys are for this map from now on.
      map.focus()
      if (!cell) return
      held = event.pointerId
      last = cell
      map.setPointerCapture(event.pointerId)
      used.press(cell)
    },
    options,
  )
  holder.addEventListener(
    'pointermove',
    (event) => {
      if (event.pointerId !== held) return
      const cell = cellOf(event)
      if (!cell || (last && cell[0] === last[0] && cell[1] === last[1])) return
      last = cell
      handlers()?.drag?.(cell)
    },
    options,
  )
  const end = (event: PointerEvent) => {
    if (event.pointerId !== held) return
    held = null
    handlers()?.release?.()
  }
  holder.addEventListener('pointerup', end, options)
  holder.addEventListener('pointercancel', end, options)
  holder.addEventListener(
    'keydown',
    (event) => {
      const used = handlers()
      if (!used || lessonMode.peek() === null || !isOnMap(event)) return
      if (event.key === 'Enter' || event.key === 'x') {
        const cell = cursor.peek()?.cell ?? scenario.peek()?.spec.start
        if (cell) used.enter(cell)
        take(event)
      } else if (used.key?.(event)) take(event)
    },
    options,
  )
  return () => listening.abort()
}

const isOnMap = ({ target }: Event) =>
  target instanceof Element && target.classList.contains('stage')
