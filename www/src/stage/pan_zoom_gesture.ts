/** The pointers that hold the map: one pans it, two pan and zoom it. */

import { type CanvasSize, type Point, panBy, viewpoint, zoomAt } from '../model/viewpoint'
import { scenario } from '../state'

export class PanZoomGesture {
  private readonly points = new Map<number, Point>()

  get active(): boolean {
    return this.points.size > 0
  }

  has(pointerId: number): boolean {
    return this.points.has(pointerId)
  }

  take(pointerId: number, at: Point): void {
    this.points.set(pointerId, at)
  }

  drop(pointerId: number): void {
    this.points.delete(pointerId)
  }

  /** What was under the fingers stays under them. */
  move(pointerId: number, at: Point, canvas: CanvasSize): void {
    const map = scenario.peek()?.spec
    if (map === undefined) return
    const before = [...this.points.values()]
    this.points.set(pointerId, at)
    const after = [...this.points.values()]
    const [from, to] = [middle(before), middle(after)]
    const shifted = panBy(viewpoint.peek(), to[0] - from[0], to[1] - from[1], canvas, map)
    const factor = spread(before) > 0 ? spread(after) / spread(before) : 1
    viewpoint.value = zoomAt(shifted, factor, to, canvas, map)
  }
}

function middle(points: Point[]): Point {
  const sum = points.reduce((total, [x, y]): Point => [total[0] + x, total[1] + y], [0, 0] as Point)
  return [sum[0] / points.length, sum[1] / points.length]
}

/** Distance of the first two fingers; 0 with one. */
function spread([first, second]: Point[]): number {
  return first && second ? Math.hypot(first[0] - second[0], first[1] - second[1]) : 0
}
