/** The ground of a terrain as a surface: heights between cells, rays that meet it. Lengths in cells, heights above the lowest cell. */
import type { Scenario } from './session'

export type Vector = [x: number, y: number, z: number]

/** The lowest and the highest ground in metres; null without a height. */
export function heightRange({
  spec,
  heights,
}: Pick<Scenario, 'spec' | 'heights'>): [number, number] | null {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]
  for (const h of heights ?? []) {
    if (h < low) low = h
    if (h > high) high = h
  }
  const unit = spec.terrain?.vertical_unit ?? 1
  return Number.isFinite(low) && Number.isFinite(high) ? [low * unit, high * unit] : null
}

/** x and z are the map's columns and rows, y is up, without exaggeration. */
export class Ground {
  readonly width: number
  readonly height: number
  /** Metres. */
  readonly lowest: number
  readonly highest: number
  /** Metres per cell: a height in metres divided by it is one in cells. */
  readonly resolution: number
  private readonly unit: number
  private readonly heights: Float32Array

  constructor({ spec, heights }: Scenario) {
    this.width = spec.width
    this.height = spec.height
    this.resolution = spec.resolution
    this.unit = spec.terrain?.vertical_unit ?? 1
    this.heights = heights ?? new Float32Array(spec.width * spec.height)
    const [lowest, highest] = heightRange({ spec, heights }) ?? [0, 0]
    this.lowest = lowest
    this.highest = highest
  }

  /** From the lowest to the highest cell. */
  get span(): number {
    return (this.highest - this.lowest) / this.resolution
  }

  /** Of an altitude in metres. */
  level(metres: number): number {
    return (metres - this.lowest) / this.resolution
  }

  /** At the nearest cell; NaN without data. */
  at(x: number, y: number): number {
    const column = Math.min(this.width - 1, Math.max(0, x))
    const row = Math.min(this.height - 1, Math.max(0, y))
    return this.level((this.heights[row * this.width + column] ?? Number.NaN) * this.unit)
  }

  /** Metres at a place of a path, counted from the centre of the first cell. */
  metresAt(x: number, y: number): number {
    return this.lowest + this.between(x + 0.5, y + 0.5) * this.resolution
  }

  /** Between the centres of cells, bilinear; NaN where one of them has no data. */
  between(x: number, z: number): number {
    const [cx, cz] = [x - 0.5, z - 0.5]
    const [left, top] = [Math.floor(cx), Math.floor(cz)]
    const [u, v] = [cx - left, cz - top]
    const upper = mix(this.at(left, top), this.at(left + 1, top), u)
    const lower = mix(this.at(left, top + 1), this.at(left + 1, top + 1), u)
    return mix(upper, lower, v)
  }

  /** Where a ray first meets the ground, seen `stretch` times as high; null when it misses it. */
  hit(from: Vector, along: Vector, stretch: number): Vector | null {
    const span = this.inside(from, along, stretch)
    if (span === null) return null
    const run = Math.hypot(along[0], along[2])
    const step = Math.min(
      0.5 / Math.max(run, 1e-9),
      0.25 / Math.max(Math.abs(along[1]), 1e-9) + 0.5,
    )
    let before = span[0]
    for (let t = span[0]; t <= span[1] + step; t += step) {
      if (this.under(from, along, t, stretch))
        return point(from, along, this.narrow(from, along, before, t, stretch))
      before = t
    }
    return null
  }

  /** Whether the ground hides a point from the eye. */
  hides(at: Vector, eye: Vector, stretch: number): boolean {
    const along: Vector = [eye[0] - at[0], eye[1] - at[1], eye[2] - at[2]]
    const length = Math.hypot(...along)
    const unit = along.map((part) => part / length) as Vector
    // A little off the ground that it stands on.
    const lift = 0.75 + 0.01 * Math.max(this.width, this.height)
    return this.hit(point(at, unit, lift), unit, stretch) !== null
  }

  private under(from: Vector, along: Vector, t: number, stretch: number): boolean {
    const [x, y, z] = point(from, along, t)
    if (x < 0 || z < 0 || x > this.width || z > this.height) return false
    return y <= this.between(x, z) * stretch
  }

  private narrow(
    from: Vector,
    along: Vector,
    above: number,
    below: number,
    stretch: number,
  ): number {
    let [low, high] = [above, below]
    for (let i = 0; i < 12; i++) {
      const middle = (low + high) / 2
      if (this.under(from, along, middle, stretch)) high = middle
      else low = middle
    }
    return high
  }

  /** The part of a ray over the map, not above its highest nor below its lowest ground. */
  private inside(from: Vector, along: Vector, stretch: number): [number, number] | null {
    const box: Vector = [this.width, this.span * stretch, this.height]
    let [near, far] = [0, Number.POSITIVE_INFINITY]
    for (const axis of [0, 1, 2] as const) {
      const [a, b] = [-from[axis] / along[axis], (box[axis] - from[axis]) / along[axis]]
      // A ray along a face gives 0 / 0 there, which says nothing.
      near = Math.max(near, Math.min(a, b) || 0)
      far = Math.min(far, Math.max(a, b) || Number.POSITIVE_INFINITY)
    }
    return near <= far && Number.isFinite(far) ? [near, far] : null
  }
}

function mix(a: number, b: number, part: number): number {
  return part === 0 ? a : a + (b - a) * part
}

function point(from: Vector, along: Vector, t: number): Vector {
  return [from[0] + along[0] * t, from[1] + along[1] * t, from[2] + along[2] * t]
}
