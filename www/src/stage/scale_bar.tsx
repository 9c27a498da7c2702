/** How long things are on a panel's map that has a scale: a line of a round length, which follows the zoom. */
import { t } from '../i18n/reading'
import type { LegendSide } from '../model/legend_place'
import { roundLength } from '../model/metres'
import { barScale, barWords } from '../words/metres'
import { LONGEST_BAR } from './legend_room'
import { type CanvasSize, place } from './panel_view'

interface ScaleBarProps {
  panelId: number
  size: CanvasSize
  side: LegendSide
}

export function ScaleBar({ panelId, size, side }: ScaleBarProps) {
  const counted = barScale.value
  if (counted === null) return null
  const perPixel = (counted * size.dpr) / place(size).scale
  const length = roundLength(perPixel, LONGEST_BAR)
  const isPartOfCell = counted === 1 && length < 1
  if (isPartOfCell) return null
  const words = barWords(length)
  return (
    <div
      class="scale-bar"
      role="img"
      aria-label={t('lengths.bar', { length: words })}
      data-side={side}
      data-length={length}
      data-testid={`scale-bar-${panelId}`}
    >
      <span class="scale-line" style={{ width: `${length / perPixel}px` }} />
      <span>{words}</span>
    </div>
  )
}
