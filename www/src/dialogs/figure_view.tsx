/** A figure under its lattice, to be corrected with pointer and keys. */
import type { RefObject } from 'preact'
import { useEffect, useMemo, useRef } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import type { Cell } from '../model/cell'
import type { FigureHand } from './figure_hand'
import { type Place, placeAt } from './figure_lattice'
import { paint, pixelsOf, type Sight, tintsOf } from './figure_paint'
import { useSight, ZOOMS } from './figure_sight'
import type { FigureState } from './figure_state'

interface ViewProps {
  figure: FigureState
  hand: FigureHand
  pane: RefObject<HTMLDivElement | null>
}

export function FigureView({ figure, hand, pane }: ViewProps) {
  const scroller = useRef<HTMLDivElement>(null)
  const canvas = useRef<HTMLCanvasElement>(null)
  const { shown, draft, classes } = figure
  const { sight, whole } = useSight(scroller, shown, hand.zoom)
  const pixels = useMemo(() => shown && pixelsOf(shown), [shown])
  const lattice = draft?.lattice ?? null
  const tints = useMemo(() => classes && lattice && tintsOf(classes, lattice), [classes, lattice])
  const { tool, cursor } = hand
  const { width, height, scale, offset } = sight
  useEffect(() => {
    if (!canvas.current || !shown) return
    const hasHandles = tool === 'lattice'
    const over = { lattice, classes, tints, cursor, hasHandles }
    paint(canvas.current, sight, { pixels, picture: shown, ...over })
  }, [shown, lattice, classes, cursor, tool, width, height, scale, ...offset])
  useEffect(() => {
    if (scroller.current && lattice && hand.cursor) reveal(scroller.current, sight, lattice, hand)
  }, [hand.cursor, hand.zoom])
  const placeOf = (event: PointerEvent): Place => {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect()
    return [
      (event.clientX - box.left - offset[0]) / scale,
      (event.clientY - box.top - offset[1]) / scale,
    ]
  }
  const looking = draft === null && figure.error === null
  return (
    <div class="figure-view">
      <div ref={scroller} class="figure-scroller" data-testid="figure-scroller">
        <div
          class="figure-whole"
          style={{ width: `${whole.width}px`, height: `${whole.height}px` }}
        >
          <div
            ref={pane}
            class="figure-pane"
            style={{ width: `${sight.width}px`, height: `${sight.height}px` }}
            data-tool={hand.tool}
            data-enlarged={hand.zoom > 0}
            data-testid="figure-pane"
            data-scale={sight.scale}
            data-offset={sight.offset.join(' ')}
            role="application"
            aria-label={t('figure.label')}
            aria-describedby="figure-keys"
            aria-busy={classes === null}
            // biome-ignore lint/a11y/noNoninteractiveTabindex: an application region is operated with the keyboard
            tabIndex={0}
            onKeyDown={hand.onKey}
            onPointerDown={(event) => {
              if (event.button !== 0) return
              event.currentTarget.setPointerCapture(event.pointerId)
              hand.press(placeOf(event), (event.pointerType === 'touch' ? 20 : 10) / sight.scale)
            }}
            onPointerMove={(event) => hand.move(placeOf(event))}
            onPointerUp={() => hand.release(true)}
            onPointerCancel={() => hand.release(false)}
          >
            <canvas ref={canvas} />
          </div>
        </div>
      </div>
      {looking && (
        <p class="figure-looking" role="status">
          {t('figure.looking')}
        </p>
      )}
    </div>
  )
}

/** Scrolls so far that the cell cursor is in sight. */
function reveal(
  scroller: HTMLDivElement,
  { width, height, scale, offset }: Sight,
  lattice: Parameters<typeof placeAt>[0],
  { cursor, zoom }: FigureHand,
): void {
  if ((ZOOMS[zoom] ?? 1) === 1) return
  const [u, v] = cursor as Cell
  const [x, y] = placeAt(lattice, u + 0.5, v + 0.5)
  const [left, top] = [x * scale + offset[0], y * scale + offset[1]]
  const room = 1.5 * Math.max(lattice.dx, lattice.dy) * scale
  const by = (at: number, side: number) => {
    const edge = Math.min(room, side / 2)
    return at < edge ? at - edge : Math.max(0, at - side + edge)
  }
  scroller.scrollBy(by(left, width), by(top, height))
}
