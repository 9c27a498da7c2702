/** Where cells lie in the world, for maps that say so: a robot's map has metres from an origin of its own. */
import type { ScenarioSpec, World } from '@pkg/formicarium'
import type { Cell } from './cell'

/** Metres a cell, of a map that has a scale, by the engine's rule (`ScenarioSpec::scale`); null elsewhere. */
export function scaleOf({ terrain, world, resolution }: ScenarioSpec): number | null {
  return terrain || world || resolution !== 1 ? resolution : null
}

/** The middle of a cell in metres, from the map's lower left corner. */
export const fromCorner = (
  { height, resolution }: ScenarioSpec,
  [x, y]: Cell,
): [number, number] => [(x + 0.5) * resolution, (height - y - 0.5) * resolution]

/** The middle of a cell in metres; null where the map's place is not known. The origin is the lower left corner, about which the map is turned. */
export function placeOf(spec: ScenarioSpec, cell: Cell): [number, number] | null {
  return spec.world ? pointOf(spec.world, ...fromCorner(spec, cell)) : null
}

/** The origin of a map whose last rows were cut off, or that got more of them. */
export function withRows(world: World, rows: number, resolution: number): World {
  const [x, y] = pointOf(world, 0, -rows * resolution)
  return { ...world, x, y }
}

/** A point so many metres to the right of the origin and above it, in the world. */
export function pointOf({ x, y, yaw = 0 }: World, east: number, north: number): [number, number] {
  const [sin, cos] = [Math.sin(yaw), Math.cos(yaw)]
  return [x + cos * east - sin * north, y + sin * east + cos * north]
}
