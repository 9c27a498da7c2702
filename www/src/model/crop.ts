/** A part of a map that was read. Pure. */
import type { Imported, Notice } from '@pkg/formicarium'
import type { Cell } from './cell'
import { keepInside } from './settle_ends'
import { pointOf } from './world'

export interface Box {
  x: number
  y: number
  width: number
  height: number
}

/** Bytes of a height or factor. */
const NUMBER = 4

/**
 * The least box around the cells that two readings of a robot's map agree on, once with unknown cells blocked and once with them free,
 * and a ring of what is unknown: whatever it counts as, the robot is as far from it as before. Null where nothing is known.
 */
export function boxOfKnown(one: Uint8Array, other: Uint8Array, width: number): Box | null {
  const height = one.length / width
  let [left, top, right, bottom] = [width, height, -1, -1]
  for (let cell = 0; cell < one.length; cell++) {
    if (one[cell] !== other[cell]) continue
    const [x, y] = [cell % width, Math.floor(cell / width)]
    left = Math.min(left, x)
    right = Math.max(right, x)
    top = Math.min(top, y)
    bottom = y
  }
  if (right < 0) return null
  const [x, y] = [Math.max(0, left - 1), Math.max(0, top - 1)]
  const [endX, endY] = [Math.min(width, right + 2), Math.min(height, bottom + 2)]
  return { x, y, width: endX - x, height: endY - y }
}

/** The part in a box, where it was in the world. Ends beside it move to the nearest free cell in it; where there is none, nothing changes. */
export function croppedTo(map: Imported, box: Box): Imported {
  const { spec } = map
  const cells = part(map.cells, spec.width, box, 1)
  const shifted = ([x, y]: Cell): Cell => [Math.max(0, x - box.x), Math.max(0, y - box.y)]
  const { world, resolution } = spec
  const below = spec.height - box.y - box.height
  const at = world && pointOf(world, box.x * resolution, below * resolution)
  const inside = keepInside(
    {
      ...spec,
      ...(world && at && { world: { ...world, x: at[0], y: at[1] } }),
      width: box.width,
      height: box.height,
      start: shifted(spec.start),
      goals: spec.goals.map((goal) => ({ ...goal, at: shifted(goal.at) })),
    },
    (cell) => cells[cell] === 0,
  )
  if (inside === null) return map
  return {
    ...map,
    spec: inside,
    cells,
    heights: part(map.heights, spec.width, box, NUMBER),
    factors: part(map.factors, spec.width, box, NUMBER),
    warnings: map.warnings.map((notice) => endsAt(notice, inside.start, inside.goals[0]?.at)),
  }
}

/** Empty where there was nothing. */
function part(bytes: Uint8Array, columns: number, box: Box, each: number): Uint8Array<ArrayBuffer> {
  if (bytes.length === 0) return new Uint8Array()
  const row = box.width * each
  const taken = new Uint8Array(row * box.height)
  for (let y = 0; y < box.height; y++) {
    const from = ((box.y + y) * columns + box.x) * each
    taken.set(bytes.subarray(from, from + row), y * row)
  }
  return taken
}

/** The remark about ends that the file does not name, with where they are now. */
function endsAt(notice: Notice, start: Cell, goal: Cell | undefined): Notice {
  if (notice.kind !== 'ends-chosen' || !goal) return notice
  const told = [notice.args.start, notice.args.goal].map((at) => `(${at?.replace(',', ', ')})`)
  const message = notice.message
    .replace(`start ${told[0]}`, `start (${start.join(', ')})`)
    .replace(`goal ${told[1]}`, `goal (${goal.join(', ')})`)
  return { ...notice, message, args: { ...notice.args, start: start.join(), goal: goal.join() } }
}
