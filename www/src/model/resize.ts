/** Another size for a map. Pure, as all edits are. */
import { takenCells } from './goals'
import type { Scenario } from './session'
import { keepInside } from './settle_ends'
import { liftEnds } from './terrain'
import { plainOrNone } from './weights'
import { withRows } from './world'

/**
 * Keeps the upper left part; new cells are free, their ground is plain, and on a terrain without data. Ends that fell off move to the nearest cell inside;
 * where no cell is left for them, nothing changes.
 */
export function resized(scenario: Scenario, width: number, height: number): Scenario {
  const { spec, heights, factors } = scenario
  if (width === spec.width && height === spec.height) return scenario
  const size = { width, height }
  const ground =
    heights && copied(heights, new Float32Array(width * height).fill(Number.NaN), spec, size)
  const weights =
    factors && plainOrNone(copied(factors, new Float32Array(width * height).fill(1), spec, size))
  const outside = new Uint8Array(width * height).fill(ground ? 1 : 0)
  const cells = copied(scenario.cells, outside, spec, size)
  const { world, resolution } = spec
  const placed = world && { world: withRows(world, height - spec.height, resolution) }
  const moved = keepInside({ ...spec, ...placed, width, height }, (cell) =>
    ground ? Number.isFinite(ground[cell]) : true,
  )
  if (moved === null) return scenario
  for (const [x, y] of takenCells(moved)) cells[y * width + x] = 0
  return (
    liftEnds({ spec: moved, cells, heights: ground, factors: weights, origin: null }) ?? scenario
  )
}

interface Size {
  width: number
  height: number
}

/** The upper left part of a map, laid over another. */
function copied<T extends Uint8Array | Float32Array>(from: T, onto: T, was: Size, is: Size): T {
  const width = Math.min(was.width, is.width)
  for (let y = 0; y < Math.min(was.height, is.height); y++)
    onto.set(from.subarray(y * was.width, y * was.width + width), y * is.width)
  return onto
}
