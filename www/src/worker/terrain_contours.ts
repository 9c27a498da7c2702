/** The contour lines of a panel's terrain. Only the whole engine has them, to keep the core small. */
import { ContourLines } from '@pkg/formicarium'
import { type ContourData, ContourLayer } from './contours'
import type { GroundOf } from './panel_server'

/** Found once for a terrain: walls, start and goal leave them as they are. */
let contours: { heights: Float32Array; unit: number; layer: ContourLayer } | null = null

/** What a terrain has besides its raster. The lines are traced when they are first drawn. */
export const contoursOf: GroundOf = ({ spec, heights }) => {
  const unit = spec.terrain?.vertical_unit
  if (!heights || unit === undefined) return null
  if (contours && contours.unit === unit && sameNumbers(contours.heights, heights))
    return contours.layer
  const trace = (): ContourData => {
    const found = new ContourLines(spec.width, heights, unit)
    const data = {
      interval: found.interval(),
      points: found.points(),
      ends: found.ends(),
      levels: found.levels(),
    }
    found.free()
    return data
  }
  contours = { heights, unit, layer: new ContourLayer(trace, heights.some(Number.isNaN)) }
  return contours.layer
}

function sameNumbers(a: Float32Array, b: Float32Array): boolean {
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]))
}
