/**
 * What every panel does next. Playing goes in rounds: each panel gets one target, and the next round is planned when all have
 * reached theirs. That alone keeps panels in step, whatever they count.
 */
import type { Frame, Target } from '../model/messages'
import type { Speed, Sync } from '../model/session'

/** What a plan needs to know of a running panel. */
export interface Standing {
  id: number
  iteration: number
  paths: number
  ants: number
}

export function standing(id: number, frame: Frame): Standing {
  const { iteration, effort, ants } = frame.summary
  return { id, iteration, paths: effort.constructed_paths, ants }
}

/**
 * The targets of one round; a panel without one is ahead of the others and waits. `batch` is what `max` speed counts in place
 * of the speed's own count (see Pace).
 */
export function planRound(
  panels: Standing[],
  speed: Speed,
  sync: Sync,
  batch: number,
): Map<number, Target> {
  const plan = planners[sync]
  return new Map(plan(panels, speed, speed.unit === 'max' ? batch : speed.count))
}

type Plan = (panels: Standing[], speed: Speed, count: number) => [number, Target][]

const planners: Record<Sync, Plan> = {
  moves: (panels, speed, count) =>
    panels.map(({ id, iteration }) => [
      id,
      speed.unit === 'iteration'
        ? { kind: 'until-iteration', iteration: iteration + count }
        : { kind: 'moves', count },
    ]),
  iterations: (panels, speed, count) => {
    const last = Math.min(...panels.map((panel) => panel.iteration))
    const iteration = last + (speed.unit === 'move' ? 1 : count)
    return panels
      .filter((panel) => panel.iteration < iteration)
      .map(({ id }) => [
        id,
        speed.unit === 'move'
          ? { kind: 'moves', count, untilIteration: iteration }
          : { kind: 'until-iteration', iteration },
      ])
  },
  // Paths are counted: the largest colony's iteration is one stride, smaller colonies run several to draw level.
  paths: (panels, speed, count) => {
    const last = Math.min(...panels.map((panel) => panel.paths))
    const stride = Math.max(1, ...panels.map((panel) => panel.ants))
    const paths = last + stride * (speed.unit === 'move' ? 1 : count)
    return panels
      .filter((panel) => panel.paths < paths)
      .map(({ id }) => [
        id,
        speed.unit === 'move'
          ? { kind: 'moves', count, untilPaths: paths }
          : { kind: 'until-paths', paths },
      ])
  },
  time: (panels) => panels.map(({ id }) => [id, { kind: 'slice' }]),
}

/** The slice a tick may take: in step by time, slower speeds get thinner slices. */
export function sliceFor(speed: Speed, sync: Sync): number {
  if (sync !== 'time' || speed.unit !== 'move') return SLICE_MS
  return Math.min(SLICE_MS, 0.1 * speed.count)
}

export const SLICE_MS = 8

/** Finds how much fits in a slice, for `as fast as possible` under a shared count: doubles while there is room, halves when not. */
export class Pace {
  batch = 1

  finish(slowestMs: number): void {
    if (slowestMs < SLICE_MS / 3) this.batch = Math.min(this.batch * 2, 1 << 14)
    else if (slowestMs > SLICE_MS) this.batch = Math.max(1, this.batch >> 1)
  }
}
