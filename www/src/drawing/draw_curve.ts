/** A path's smooth curve, over the path. */
import type { Smoothed } from '@pkg/formicarium'
import type { PanelView } from '../model/messages'
import { centre, MAP_COLOURS } from './draw_map'

/** Unlike every panel's own colour, so that it is seen where it leaves its path and where it lies on it. */
export const CURVE_COLOURS = { light: '#1c1712', dark: '#fff3dc' }

export function drawCurve(
  context: OffscreenCanvasRenderingContext2D,
  view: PanelView,
  curve: Smoothed | null,
): void {
  if (!curve?.is_curve) return
  const line = new Path2D()
  for (const [x, y] of curve.points) line.lineTo(...centre(view, x, y))
  const width = Math.min(2.25 * view.dpr, Math.max(1.25 * view.dpr, 0.09 * view.scale))
  context.lineJoin = 'round'
  context.lineCap = 'round'
  for (const [colour, wide] of [
    [MAP_COLOURS[view.theme].halo, width + 2 * view.dpr],
    [CURVE_COLOURS[view.theme], width],
  ] as const) {
    context.strokeStyle = colour
    context.lineWidth = wide
    context.stroke(line)
  }
}
