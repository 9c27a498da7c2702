/** Where cells lie in the world, for maps that say so: a robot's map has metres from an origin of its own. */
import type { ScenarioSpec, World } from '@pkg/formicarium'
import type { Cell } from './cell'

/** The middle of a cell in metres; null where the map's place is not known. The origin is the lower left corner, about which the map is turned. */
export function placeOf(
  { world, height, resolution }: ScenarioSpec,
  [x, y]: Cell,
): [number, number] | null {
  return world ? pointOf(world, (x + 0.5) * resolution, (height - y - 0.5) * resolution) : null
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
