/** The ground as triangles: a lattice with a limited number of places a side, and walls down to a plinth around it. */
import { BufferAttribute, BufferGeometry } from 'three'
import type { Ground } from '../model/relief_ground'

/** Larger maps are drawn coarser: a screen shows no more, and a slow machine can still turn them. */
export const MOST_PLACES = 257

export class Lattice {
  readonly xs: number[]
  readonly zs: number[]
  /** Row by row; NaN without data. */
  readonly heights: Float32Array

  constructor(ground: Ground, most = MOST_PLACES) {
    this.xs = stations(ground.width, most)
    this.zs = stations(ground.height, most)
    this.heights = new Float32Array(this.xs.length * this.zs.length)
    let i = 0
    for (const z of this.zs) {
      for (const x of this.xs) this.heights[i++] = ground.at(Math.floor(x), Math.floor(z))
    }
  }

  /** Between the places, as the triangles have it but for their diagonal. */
  between(x: number, z: number): number {
    const [i, u] = locate(this.xs, x)
    const [j, v] = locate(this.zs, z)
    const at = (a: number, b: number) => this.heights[b * this.xs.length + a] ?? Number.NaN
    const upper = at(i, j) + (at(i + 1, j) - at(i, j)) * u
    const lower = at(i, j + 1) + (at(i + 1, j + 1) - at(i, j + 1)) * u
    return upper + (lower - upper) * v
  }
}

/** Centres of cells, evenly, with the first and the last of them, and the map's edges. */
function stations(cells: number, most: number): number[] {
  const parts = Math.min(cells, most) - 1
  const inner = Array.from({ length: parts + 1 }, (_, i) =>
    parts === 0 ? 0.5 : Math.round((i * (cells - 1)) / parts) + 0.5,
  )
  return [0, ...inner, cells - 0.001]
}

function locate(stations: number[], at: number): [number, number] {
  let [low, high] = [0, stations.length - 1]
  while (high - low > 1) {
    const middle = (low + high) >> 1
    if ((stations[middle] ?? 0) <= at) low = middle
    else high = middle
  }
  const [from, to] = [stations[low] ?? 0, stations[high] ?? 1]
  return [low, Math.min(1, Math.max(0, (at - from) / (to - from)))]
}

/** Ground with the map's picture on it. Squares with a corner that has no data are left open. */
export function groundMesh({ xs, zs, heights }: Lattice, ground: Ground): BufferGeometry {
  const positions = new Float32Array(3 * heights.length)
  const uvs = new Float32Array(2 * heights.length)
  for (let i = 0; i < heights.length; i++) {
    const x = xs[i % xs.length] ?? 0
    const z = zs[Math.floor(i / xs.length)] ?? 0
    positions.set([x, heights[i] || 0, z], 3 * i)
    uvs.set([x / ground.width, z / ground.height], 2 * i)
  }
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(positions, 3))
  geometry.setAttribute('uv', new BufferAttribute(uvs, 2))
  geometry.setIndex(new BufferAttribute(new Uint32Array(triangles(xs.length, heights)), 1))
  geometry.computeVertexNormals()
  return geometry
}

/** Each square is cut along the diagonal that joins the more equal heights: ridges and valleys stay whole. */
function triangles(width: number, heights: Float32Array): number[] {
  const faces: number[] = []
  for (let nw = 0; nw + width + 1 < heights.length; nw++) {
    if (nw % width === width - 1) continue
    const [ne, sw, se] = [nw + 1, nw + width, nw + width + 1]
    const [a = 0, b = 0, c = 0, d = 0] = [heights[nw], heights[ne], heights[sw], heights[se]]
    if (Number.isNaN(a + b + c + d)) continue
    if (Math.abs(a - d) < Math.abs(b - c)) faces.push(nw, sw, se, nw, se, ne)
    else faces.push(nw, sw, ne, ne, sw, se)
  }
  return faces
}

/** The four sides of the block that the terrain is cut from, down to `base`. */
export function plinthMesh({ xs, zs, heights }: Lattice, base: number): BufferGeometry {
  const positions: number[] = []
  const [columns, rows] = [xs.length, zs.length]
  const wall = (a: number, b: number) => {
    const [ha, hb] = [heights[a] ?? Number.NaN, heights[b] ?? Number.NaN]
    if (Number.isNaN(ha + hb)) return
    const [ax, az] = [xs[a % columns] ?? 0, zs[Math.floor(a / columns)] ?? 0]
    const [bx, bz] = [xs[b % columns] ?? 0, zs[Math.floor(b / columns)] ?? 0]
    positions.push(ax, ha, az, ax, base, az, bx, base, bz, ax, ha, az, bx, base, bz, bx, hb, bz)
  }
  for (let i = 0; i + 1 < columns; i++) {
    wall(i, i + 1)
    wall((rows - 1) * columns + i, (rows - 1) * columns + i + 1)
  }
  for (let j = 0; j + 1 < rows; j++) {
    wall(j * columns, (j + 1) * columns)
    wall((j + 1) * columns - 1, (j + 2) * columns - 1)
  }
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3))
  geometry.computeVertexNormals()
  return geometry
}
