/** A path over a terrain as distances and altitudes. */
import type { Cell } from '../model/cell'
import type { Ground } from '../model/relief_ground'

export interface Profile {
  /** Metres along the path as the map has it, without ups and downs. */
  distances: number[]
  /** Metres. */
  altitudes: number[]
  /** Heights of the ground below a path by slices, if asked for; any other path lies on the ground. */
  ground: number[] | null
  /** Where on the map each point is. */
  cells: Cell[]
}

/**
 * A point for every cell that a segment passes, as the engine follows the ground (src/map/relief.rs): the climb of the profile is the
 * climb of the path. `path`: x0, y0, x1, y1, …; `altitudes`: metres at these places.
 */
export function profileOf(
  path: Uint32Array,
  altitudes: Float64Array,
  ground: Ground,
  bySlices: boolean,
  withGround = bySlices,
): Profile {
  const profile: Profile = {
    distances: [],
    altitudes: [],
    ground: withGround ? [] : null,
    cells: [],
  }
  let distance = 0
  for (let place = 0; place < altitudes.length; place++) {
    const [x, y] = [path[2 * place] ?? 0, path[2 * place + 1] ?? 0]
    const before = Math.max(0, place - 1)
    const [x0, y0] = [path[2 * before] ?? x, path[2 * before + 1] ?? y]
    const [from, to] = [altitudes[before] ?? 0, altitudes[place] ?? 0]
    const parts = Math.max(1, Math.abs(x - x0), Math.abs(y - y0))
    const run = (Math.hypot(x - x0, y - y0) / parts) * ground.resolution
    for (let k = place === 0 ? parts : 1; k <= parts; k++) {
      const at: Cell = [x0 + ((x - x0) * k) / parts, y0 + ((y - y0) * k) / parts]
      const below = ground.metresAt(...at)
      distance += run
      profile.distances.push(distance)
      profile.altitudes.push(bySlices ? from + ((to - from) * k) / parts : below)
      profile.ground?.push(below)
      profile.cells.push([Math.round(at[0]), Math.round(at[1])])
    }
  }
  return profile
}

/** Index of the point nearest to a distance; -1 without points. */
export function nearest({ distances }: Profile, distance: number): number {
  let [low, high] = [0, distances.length - 1]
  while (high - low > 1) {
    const middle = (low + high) >> 1
    if ((distances[middle] ?? 0) <= distance) low = middle
    else high = middle
  }
  const [before, after] = [distances[low] ?? 0, distances[high] ?? 0]
  return distance - before < after - distance ? low : high
}
