/** Places in the world, and the cells in which they lie. */
import type { ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from './cell'

/** The cell in which a place in metres lies, beside the map too; from the lower left corner where the map's place is not known. */
export function cellOfPlace(
  { world, height, resolution }: ScenarioSpec,
  [x, y]: readonly [number, number],
): Cell {
  const { x: left, y: bottom, yaw = 0 } = world ?? { x: 0, y: 0 }
  const [sin, cos] = [Math.sin(yaw), Math.cos(yaw)]
  const [dx, dy] = [x - left, y - bottom]
  const column = Math.floor((cos * dx + sin * dy) / resolution)
  return [column, height - 1 - Math.floor((cos * dy - sin * dx) / resolution)]
}
