/** The room that a legend takes, and when it may move: not while anything is pressed. Read inside a component. */
import { signal } from '@preact/signals'
import { type LegendPlace, type LegendShape, legendPlace } from '../model/legend_place'
import type { CanvasSize, Size } from '../model/viewpoint'
import { scenario } from '../state'
import { place } from './panel_view'

/** Whether a finger or a button of the mouse is down. */
export const held = signal(false)
const hold = (down: boolean) => () => {
  held.value = down
}
const PASSIVE = { capture: true, passive: true }
addEventListener('pointerdown', hold(true), PASSIVE)
for (const end of ['pointerup', 'pointercancel']) addEventListener(end, hold(false), PASSIVE)

/** Of one row, in CSS pixels; the styles give a legend the same (legend.css). */
const ROW: Record<LegendShape, Size> = {
  full: { width: 184, height: 40 },
  line: { width: 264, height: 20 },
  bar: { width: 160, height: 20 },
}

/** A small stage has room for one ramp: the one that was chosen. */
export const hasRoomForBoth = ({ width, height, dpr }: CanvasSize) =>
  width >= 420 * dpr && height >= 260 * dpr

export function placeLegend(
  size: CanvasSize,
  rows: 1 | 2,
  before: LegendPlace | null,
): LegendPlace | null {
  const now = scenario.value
  if (!now) return null
  const { dpr } = size
  const { scale, originX, originY } = place(size)
  const map = { left: originX / dpr, top: originY / dpr, cell: scale / dpr }
  const stage = { width: size.width / dpr, height: size.height / dpr }
  const high = (shape: LegendShape) => ({ ...ROW[shape], height: rows * ROW[shape].height })
  const sizes = { full: high('full'), line: high('line'), bar: high('bar') }
  return legendPlace(stage, map, now, sizes, before)
}
