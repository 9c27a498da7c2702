/** The worker's side of a lesson. */
import type * as whole from '@pkg/formicarium'
import { KEPT_BYTES } from '../model/kept_bytes'
import type { Followed, LessonCalls } from '../model/lesson_calls'

type Engine = Pick<typeof whole, 'Run' | 'HandPath'>

/** Iterations repeated between two looks at the clock. */
const AT_ONCE = 8

export function lessonCalls(engine: Engine): LessonCalls {
  let follower: Follower | null = null
  let map: whole.HandPath | null = null
  return {
    followRun({ spec, cells, heights, factors, planner, params, seed }) {
      const run = new engine.Run(spec, cells, heights, factors, planner, params, seed)
      follower?.free()
      follower = new Follower(run)
    },
    followTo: (iteration, moves, milliseconds) =>
      begun(follower).goTo(iteration, moves, milliseconds),
    followedAnt: (number) => begun(follower).ahead?.ant(number) ?? null,
    followedAnts: () => begun(follower).ahead?.ants() ?? new Int32Array(),
    drawOn(...asked) {
      const next = new engine.HandPath(...asked)
      map?.free()
      map = next
    },
    drawTowards([x, y], [toX, toY]) {
      const flat = begun(map).towards(x, y, toX, toY)
      return Array.from({ length: flat.length / 2 }, (_, i) => [
        flat[2 * i] ?? 0,
        flat[2 * i + 1] ?? 0,
      ])
    },
    measureDrawn: (path) => begun(map).measure(path),
  }
}

function begun<T>(thing: T | null): T {
  if (thing === null) throw new Error('nothing has begun')
  return thing
}

/** A run of its own, of which one ant is followed: forth as the run goes, and back as far as it went. */
class Follower {
  ahead: whole.LookAhead | null = null
  private at = 0
  private moves = 0

  constructor(private readonly run: whole.Run) {
    run.keep_snapshots(KEPT_BYTES)
  }

  goTo(iteration: number, moves: number, milliseconds: number): Followed {
    const ends = performance.now() + milliseconds
    const inTime = () => performance.now() < ends
    while (this.mayGoOn(iteration) && inTime()) this.run.advance('iteration', 1)
    let arrived = !this.mayGoOn(iteration)
    if (arrived && (this.ahead === null || this.at !== iteration || moves < this.moves)) {
      do arrived = this.run.show_iteration(iteration, AT_ONCE)
      while (!arrived && inTime())
      if (arrived) this.lookAhead(iteration)
    }
    if (arrived) this.moves = this.ahead?.go_to(moves) ?? 0
    const { iteration: shown, digest } = this.run.summary()
    const over = this.ahead?.is_over() ?? false
    return { arrived, iteration: shown, moves: this.moves, over, digest }
  }

  free(): void {
    this.ahead?.free()
    this.run.free()
  }

  private mayGoOn(iteration: number): boolean {
    return this.run.status() === 'running' && this.run.iteration() < iteration
  }

  private lookAhead(iteration: number): void {
    this.ahead?.free()
    this.ahead = this.run.look_ahead()
    this.at = iteration
    this.moves = 0
  }
}
