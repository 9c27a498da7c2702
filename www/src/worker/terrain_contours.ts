/** The contour lines of a panel's terrain. Only the whole engine has them, to keep the core small. */
import { ContourLines } from '@pkg/formicarium'
import type { RunSetup } from '../model/messages'
import type { ContourData } from '../model/terrain'
import { ContourLayer } from './contours'

/** Found once for a terrain: walls, start and goal leave them as they are. */
let contours: { heights: Float32Array; unit: number; layer: ContourLayer } | null = null

/** What a terrain has besides its raster. The lines are traced when they are first drawn. */
export function contoursOf({ spec, heights }: RunSetup): ContourLayer | null {
  const unit = spec.terrain?.vertical_unit
  if (!heights || unit === undefined) return null
  if (contours && contours.unit === unit && sameNumbers(contours.heights, heights))
    return contours.layer
  const trace = () => traceContours(spec.width, heights, unit)
  contours = { heights, unit, layer: new ContourLayer(trace, heights.some(Number.isNaN)) }
  return contours.layer
}

/** `unit`: metres per unit of the heights. */
export function traceContours(width: number, heights: Float32Array, unit: number): ContourData {
  const found = new ContourLines(width, heights, unit)
  const data = {
    interval: found.interval(),
    points: found.points(),
    ends: found.ends(),
    levels: found.levels(),
  }
  found.free()
  return data
}

function sameNumbers(a: Float32Array, b: Float32Array): boolean {
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]))
}
