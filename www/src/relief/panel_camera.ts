/** One panel's camera: its position for the shared eye, and the mapping between map and picture. */
import { PerspectiveCamera, Vector3 } from 'three'
import type { Ground, Vector } from '../model/relief_ground'
import type { Eye } from './eye'

const FIELD_OF_VIEW = 28
/** Share of the picture that the whole map may take; marks at its corners need room. */
const ROOM = 0.93
/** Points of the circle around the map that must be in view, so that the map keeps its size while it is turned. */
const AROUND = 16

export class PanelCamera {
  readonly perspective = new PerspectiveCamera(FIELD_OF_VIEW)
  private width = 1
  private height = 1
  private stretch = 1
  /** From the map's middle to its corners. */
  private reach = 1

  /** For a picture of this size. */
  aim(eye: Eye, ground: Ground, stretch: number, width: number, height: number): void {
    const { perspective: camera } = this
    this.width = width
    this.height = height
    this.stretch = stretch
    camera.aspect = width / height
    const target: Vector = [eye.centreX * ground.width, 0, eye.centreY * ground.height]
    target[1] = (ground.between(target[0], target[2]) || 0) * stretch
    const whole = this.fit(eye, ground)
    this.stand(target, eye, whole.distance / eye.zoom)
    const { position } = camera
    const floor = (ground.between(position.x, position.z) || 0) * stretch + camera.near
    if (position.y < floor) {
      position.y = floor
      camera.lookAt(...target)
    }
    camera.updateProjectionMatrix()
    // What is looked at stands a little above the middle: the nearer half of the map looks larger.
    const { elements } = camera.projectionMatrix
    elements[9] = (elements[9] ?? 0) - whole.lower
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert()
    camera.updateMatrixWorld()
  }

  private stand([x, y, z]: Vector, { azimuth, elevation }: Eye, distance: number): void {
    const { perspective: camera } = this
    const out = Math.cos(elevation) * distance
    const up = Math.sin(elevation) * distance
    camera.position.set(x + Math.sin(azimuth) * out, y + up, z + Math.cos(azimuth) * out)
    camera.near = 0.02 * distance
    camera.far = 3 * distance + 2 * this.reach
    camera.lookAt(x, y, z)
    camera.updateProjectionMatrix()
    camera.updateMatrixWorld()
  }

  /** The distance from which the whole map is in view, and by how much the picture's middle lies below what is looked at. */
  private fit(eye: Eye, ground: Ground): { distance: number; lower: number } {
    const middle: Vector = [ground.width / 2, 0.4 * ground.span * this.stretch, ground.height / 2]
    this.reach = Math.hypot(ground.width, ground.height) / 2
    let [low, high] = [0.5 * this.reach, 12 * this.reach]
    let lower = 0
    for (let i = 0; i < 14; i++) {
      const distance = (low + high) / 2
      this.stand(middle, eye, distance)
      const seen = this.extent(middle)
      lower = (seen.top + seen.bottom) / 2
      const fits = seen.side <= ROOM && (seen.top - seen.bottom) / 2 <= ROOM
      if (fits) high = distance
      else low = distance
    }
    return { distance: high, lower: -lower }
  }

  /** Where the circle around the map lies in the picture, from -1 to 1. */
  private extent([x, y, z]: Vector): { side: number; top: number; bottom: number } {
    const seen = { side: 0, top: -1e9, bottom: 1e9 }
    for (let i = 0; i < AROUND; i++) {
      const turn = (2 * Math.PI * i) / AROUND
      for (const level of [0, 1.5 * y]) {
        const at = new Vector3(
          x + Math.cos(turn) * this.reach,
          level,
          z + Math.sin(turn) * this.reach,
        )
        at.project(this.perspective)
        // Behind the eye everything is upside down: much too near.
        if (at.z > 1) return { side: 9, top: 9, bottom: -9 }
        seen.side = Math.max(seen.side, Math.abs(at.x))
        seen.top = Math.max(seen.top, at.y)
        seen.bottom = Math.min(seen.bottom, at.y)
      }
    }
    return seen
  }

  /** Where the eye stands, in the stretched world. */
  get position(): Vector {
    const { x, y, z } = this.perspective.position
    return [x, y, z]
  }

  /** Where a place on the unstretched map is in the picture; null behind the eye. */
  project([x, y, z]: Vector): [number, number] | null {
    const at = new Vector3(x, y * this.stretch, z).project(this.perspective)
    if (at.z > 1) return null
    return [((at.x + 1) / 2) * this.width, ((1 - at.y) / 2) * this.height]
  }

  /** The direction in which the eye sees a point of the picture. */
  ray([px, py]: [number, number]): Vector {
    const at = new Vector3((2 * px) / this.width - 1, 1 - (2 * py) / this.height, 0.5)
    const { x, y, z } = at.unproject(this.perspective).sub(this.perspective.position).normalize()
    return [x, y, z]
  }
}
