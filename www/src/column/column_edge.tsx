/** The edge between maps and column: dragged, or moved by keys, it makes the column wider or narrower. */
import { useRef } from 'preact/hooks'
import { t } from '../i18n'
import { columnWidth, setColumnWidth } from '../state'

/** CSS pixels; the styles keep the column within the same limits. */
const LEAST = 260
const most = () => Math.max(LEAST, Math.round(innerWidth * 0.5))
const STEP = 16

export function ColumnEdge() {
  const edge = useRef<HTMLDivElement>(null)
  /** Where it was taken hold of, and how wide the column was then. */
  const held = useRef({ x: 0, width: 0 })
  const widthNow = () => edge.current?.closest('.column')?.getBoundingClientRect().width ?? LEAST
  const choose = (width: number) => setColumnWidth(Math.min(most(), Math.max(LEAST, width)))
  const onKeyDown = (event: KeyboardEvent) => {
    const width = {
      ArrowLeft: widthNow() + STEP,
      ArrowRight: widthNow() - STEP,
      Home: most(),
      End: LEAST,
    }[event.key]
    if (width === undefined) return
    event.preventDefault()
    event.stopPropagation()
    choose(width)
  }
  return (
    // biome-ignore lint/a11y/useSemanticElements: an <hr> cannot be moved
    <div
      ref={edge}
      class="column-edge"
      role="separator"
      aria-orientation="vertical"
      aria-label={t('column.edge')}
      aria-valuemin={LEAST}
      aria-valuemax={most()}
      aria-valuenow={Math.round(columnWidth.value ?? widthNow())}
      tabIndex={0}
      data-testid="column-edge"
      onKeyDown={onKeyDown}
      onDblClick={() => setColumnWidth(null)}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId)
        held.current = { x: event.clientX, width: widthNow() }
      }}
      onPointerMove={(event) => {
        if (!event.currentTarget.hasPointerCapture(event.pointerId)) return
        choose(held.current.width + held.current.x - event.clientX)
      }}
    />
  )
}
