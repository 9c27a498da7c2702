/** What a map has besides its raster on the whole engine: contour lines and, where the vehicle wants them, smooth curves over paths. */
import { drawCurve } from '../drawing/draw_curve'
import { curveOf } from './curve'
import type { Ground } from './painter'
import type { GroundOf } from './panel_server'
import { contoursOf } from './terrain_contours'

export const groundOf: GroundOf = (setup, run) => {
  const contours = contoursOf(setup)
  if (!run || !setup.spec.vehicle.smoothing) return contours
  return {
    hasHoles: contours?.hasHoles ?? false,
    draw: (...asked) => contours?.draw(...asked),
    drawOver: (context, view) => drawCurve(context, view, curveOf(run).curve),
  } satisfies Ground
}
