/** Ants: three-part bodies that point where they go. All bodies of a crowd are one path, so hundreds cost a few calls. */
import type { PanelView } from '../model/messages'
import type { Ant } from './crowd'

type Context = OffscreenCanvasRenderingContext2D

const INK = {
  light: { body: '#1c1712', halo: 'rgba(255, 255, 255, 0.9)' },
  dark: { body: '#fff3dc', halo: 'rgba(10, 12, 18, 0.85)' },
}

const TURN = 2 * Math.PI
/** Spreads the ants of one cell like seeds in a sunflower. */
const GOLDEN_ANGLE = 2.399963

interface Pose {
  x: number
  y: number
  /** Unit vector of the heading. */
  dx: number
  dy: number
  gait: number
}

/** `progress`: how far from the last cell to the present one, 0 to 1. */
export function drawCrowd(context: Context, view: PanelView, ants: Ant[], progress: number): void {
  if (ants.length === 0) return
  const { dpr, scale } = view
  const length = Math.min(24 * dpr, Math.max(7 * dpr, 0.85 * scale))
  const poses = ants
    .map((ant) => pose(ant, view, progress))
    .filter((p) => isVisible(p, view, length))
  const ink = INK[view.theme]
  const bodies = bodiesPath(poses, length)
  context.lineJoin = 'round'
  context.lineCap = 'round'
  context.strokeStyle = ink.halo
  context.lineWidth = 2.5 * dpr
  context.stroke(bodies)
  if (length >= 9 * dpr) {
    context.strokeStyle = ink.body
    context.lineWidth = Math.max(1, 0.06 * length)
    context.stroke(legsPath(poses, length))
  }
  context.fillStyle = ink.body
  context.fill(bodies)
}

function pose(ant: Ant, view: PanelView, progress: number): Pose {
  const angle = ant.id * GOLDEN_ANGLE
  const spread = Math.max(0.28 * view.scale, 2 * view.dpr) * Math.sqrt((ant.id % 16) / 16)
  const x = ant.fromX + (ant.x - ant.fromX) * progress + 0.5
  const y = ant.fromY + (ant.y - ant.fromY) * progress + 0.5
  return {
    x: view.originX + x * view.scale + spread * Math.cos(angle),
    y: view.originY + y * view.scale + spread * Math.sin(angle),
    dx: Math.cos(ant.heading),
    dy: Math.sin(ant.heading),
    gait: Math.sin(2 * Math.PI * progress + 3 * (ant.x + ant.y) + ant.id),
  }
}

function isVisible({ x, y }: Pose, view: PanelView, margin: number): boolean {
  return x > -margin && y > -margin && x < view.width + margin && y < view.height + margin
}

/** Abdomen, thorax, head, from back to front: position along the body and radius, in body lengths. */
const PARTS = [
  [-0.28, 0.22],
  [0.06, 0.12],
  [0.32, 0.16],
] as const

function bodiesPath(poses: Pose[], length: number): Path2D {
  const path = new Path2D()
  for (const { x, y, dx, dy } of poses) {
    for (const [along, radius] of PARTS) {
      const cx = x + dx * along * length
      const cy = y + dy * along * length
      path.moveTo(cx + radius * length, cy)
      path.arc(cx, cy, radius * length, 0, TURN)
    }
  }
  return path
}

/** Three pairs of legs that swing in turn. */
function legsPath(poses: Pose[], length: number): Path2D {
  const path = new Path2D()
  const reach = 0.36 * length
  for (const { x, y, dx, dy, gait } of poses) {
    for (const pair of [-1, 0, 1]) {
      const swing = (0.22 * pair + 0.1 * gait * (pair === 0 ? -1 : 1)) * length
      const rootX = x + dx * (0.06 + 0.07 * pair) * length
      const rootY = y + dy * (0.06 + 0.07 * pair) * length
      path.moveTo(rootX - dy * reach + dx * swing, rootY + dx * reach + dy * swing)
      path.lineTo(rootX, rootY)
      path.lineTo(rootX + dy * reach + dx * swing, rootY - dx * reach + dy * swing)
    }
  }
  return path
}
