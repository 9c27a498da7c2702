/** What one panel shows on the ground: its raster, its best path, its ants. */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  LinearFilter,
  LineBasicMaterial,
  LineSegments,
  NearestFilter,
  Points,
  PointsMaterial,
  SRGBColorSpace,
  Texture,
} from 'three'
import { Line2 } from 'three/examples/jsm/lines/Line2.js'
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js'
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js'
import type { PanelView } from '../model/messages'
import type { Ground } from '../model/relief_ground'
import type { Lattice } from './ground_mesh'

const HALO = { light: '#ffffff', dark: '#0c0e14' }
const ANT = { light: '#1c1712', dark: '#fff3dc' }
/** Cells of smaller maps are squares with edges, of larger ones a picture. */
const CRISP_UP_TO = 96

export interface PathOnGround {
  /** x0, y0, x1, y1, … */
  cells: Uint32Array
  /** Metres. */
  altitudes: Float64Array
  /** In the air: drawn at its altitudes, with lines down to the ground. */
  bySlices: boolean
}

export class PanelContent {
  /** Path and ants, in cells; stretched together with the ground. */
  readonly group = new Group()
  texture: Texture | null = null
  private readonly ghost = line(1)
  private readonly halo = line(2)
  private readonly path = line(3)
  private readonly drops = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ transparent: true, opacity: 0.55 }),
  )
  private readonly ants = new Points(new BufferGeometry(), dots())

  constructor() {
    // Where the ground hides the path it shines through.
    Object.assign(this.ghost.material, { depthTest: false, transparent: true, opacity: 0.32 })
    this.group.add(this.ghost, this.halo, this.path, this.drops, this.ants)
    for (const child of this.group.children) child.frustumCulled = false
  }

  /** Takes the bitmap over. */
  setPicture(bitmap: ImageBitmap): void {
    const before = this.texture
    this.texture = new Texture(bitmap)
    this.texture.colorSpace = SRGBColorSpace
    this.texture.flipY = false
    this.texture.generateMipmaps = false
    this.texture.minFilter = LinearFilter
    this.texture.magFilter =
      Math.max(bitmap.width, bitmap.height) > CRISP_UP_TO ? LinearFilter : NearestFilter
    this.texture.needsUpdate = true
    drop(before)
  }

  setLook(colour: string, theme: PanelView['theme'], dpr: number): void {
    this.halo.material.color = new Color(HALO[theme])
    this.halo.material.linewidth = 6.5 * dpr
    for (const { material } of [this.path, this.ghost]) material.color = new Color(colour)
    for (const { material } of [this.path, this.ghost]) material.linewidth = 3.5 * dpr
    this.drops.material.color = new Color(colour)
    this.ants.material.color = new Color(ANT[theme])
    this.ants.material.size = 4.5 * dpr
  }

  setPath(path: PathOnGround | null, ground: Ground, lattice: Lattice, lift: number): void {
    const points = path ? pathPoints(path, ground, lattice, lift) : []
    for (const drawn of [this.ghost, this.halo, this.path]) {
      drawn.visible = points.length > 3
      if (!drawn.visible) continue
      drawn.geometry.dispose()
      drawn.geometry = new LineGeometry()
      drawn.geometry.setPositions(points)
    }
    this.drops.visible = path?.bySlices === true
    if (path?.bySlices) setPoints(this.drops.geometry, dropPoints(path, ground))
  }

  /** `cells`: x0, y0, x1, y1, … */
  setAnts(cells: Uint32Array, ground: Ground, lattice: Lattice, lift: number): void {
    const points: number[] = []
    for (let i = 0; i + 1 < cells.length; i += 2) {
      const [x, z] = [(cells[i] ?? 0) + 0.5, (cells[i + 1] ?? 0) + 0.5]
      points.push(x, surface(x, z, ground, lattice) + lift, z)
    }
    this.ants.visible = points.length > 0
    setPoints(this.ants.geometry, points)
  }

  dispose(): void {
    drop(this.texture)
    for (const child of [this.ghost, this.halo, this.path, this.drops, this.ants]) {
      child.geometry.dispose()
      child.material.dispose()
    }
  }
}

function line(order: number): Line2 {
  const made = new Line2(new LineGeometry(), new LineMaterial({ depthWrite: false }))
  made.renderOrder = order
  made.visible = false
  return made
}

/** Round ones. */
function dots(): PointsMaterial {
  const material = new PointsMaterial({ sizeAttenuation: false, depthWrite: false })
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      '#include <color_fragment>',
      '#include <color_fragment>\nif (length(gl_PointCoord - 0.5) > 0.5) discard;',
    )
  }
  return material
}

function drop(texture: Texture | null): void {
  texture?.dispose()
  if (texture?.image instanceof ImageBitmap) texture.image.close()
}

function setPoints(geometry: BufferGeometry, points: number[]): void {
  geometry.dispose()
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3))
}

/** The higher of the true ground and the coarser one that is drawn: nothing that lies on it sinks in. */
function surface(x: number, z: number, ground: Ground, lattice: Lattice): number {
  const [exact, drawn] = [ground.between(x, z), lattice.between(x, z)]
  return Math.max(exact || 0, drawn || 0)
}

/** On the ground at every cell that the path passes; in the air straight from place to place. */
function pathPoints(
  { cells, altitudes, bySlices }: PathOnGround,
  ground: Ground,
  lattice: Lattice,
  lift: number,
): number[] {
  const points: number[] = []
  for (let i = 0; i + 1 < cells.length; i += 2) {
    const [x, z] = [(cells[i] ?? 0) + 0.5, (cells[i + 1] ?? 0) + 0.5]
    if (bySlices) {
      points.push(x, ground.level(altitudes[i / 2] ?? 0), z)
      continue
    }
    const [fromX, fromZ] = i === 0 ? [x, z] : [(cells[i - 2] ?? 0) + 0.5, (cells[i - 1] ?? 0) + 0.5]
    const parts = Math.max(1, Math.abs(x - fromX), Math.abs(z - fromZ)) * (i === 0 ? 1 : 2)
    for (let k = i === 0 ? parts : 1; k <= parts; k++) {
      const [px, pz] = [fromX + ((x - fromX) * k) / parts, fromZ + ((z - fromZ) * k) / parts]
      points.push(px, surface(px, pz, ground, lattice) + lift, pz)
    }
  }
  return points
}

function dropPoints({ cells, altitudes }: PathOnGround, ground: Ground): number[] {
  return Array.from({ length: altitudes.length }, (_, i) => {
    const [x, z] = [(cells[2 * i] ?? 0) + 0.5, (cells[2 * i + 1] ?? 0) + 0.5]
    return [x, ground.level(altitudes[i] ?? 0), z, x, ground.between(x, z) || 0, z]
  }).flat()
}
