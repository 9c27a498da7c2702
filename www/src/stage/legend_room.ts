/** The room that a legend takes, and when it may move: not while anything is pressed. Read inside a component. */
import { signal } from '@preact/signals'
import {
  barSide,
  type LegendPlace,
  type LegendShape,
  type LegendSide,
  legendPlace,
} from '../model/legend_place'
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

/** Of a scale bar with its words (legend.css), and of its line alone. */
const BAR: Size = { width: 152, height: 20 }
export const LONGEST_BAR = 80

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
  const sizes = { full: high('full', rows), line: high('line', rows), bar: high('bar', rows) }
  const { stage, map } = laid(size)
  return legendPlace(stage, map, now, sizes, before)
}

/** Where a scale bar stands beside a legend of so many rows; null where it has no place. */
export function placeBar(
  size: CanvasSize,
  legend: LegendPlace | null,
  rows: 1 | 2,
  before: LegendSide | null,
): LegendSide | null {
  const now = scenario.value
  if (!now) return null
  const taken = legend && { side: legend.side, size: high(legend.shape, rows) }
  const { stage, map } = laid(size)
  return barSide(stage, map, now, BAR, taken, before)
}

const high = (shape: LegendShape, rows: number) => ({
  ...ROW[shape],
  height: rows * ROW[shape].height,
})

/** The stage, and the map on it, in CSS pixels. */
function laid(size: CanvasSize) {
  const { dpr } = size
  const { scale, originX, originY } = place(size)
  return {
    stage: { width: size.width / dpr, height: size.height / dpr },
    map: { left: originX / dpr, top: originY / dpr, cell: scale / dpr },
  }
}
