/** Has a run stop where something happens: it goes step by step, and looks at the run where one could have mattered. */
import type { RunSummary } from '@pkg/formicarium'
import type { Stop } from '../model/lesson'
import type { Target } from '../model/messages'
import { type Steppable, Stepper } from './stepper'

/** A run that stands still as soon as it has met a stop. */
class Watched implements Steppable {
  met: Stop[] = []
  private stops: Stop[] = []
  private before: RunSummary

  constructor(private readonly run: Steppable) {
    this.before = run.summary()
  }

  /** Watches from where the run stands now. */
  begin(stops: Stop[]): void {
    this.met = []
    this.stops = stops
    this.before = this.run.summary()
  }

  advance(by: 'move' | 'iteration', count: number) {
    for (let made = 0; made < count && this.status() === 'running'; made++) {
      this.run.advance(by, 1)
      // Paths and ends come with the end of an iteration, or of the run.
      const { iteration, status } = this.before
      if (this.run.iteration() !== iteration || this.run.status() !== status) this.look()
    }
    return this.status()
  }

  status() {
    return this.met.length > 0 ? ('stopped' as const) : this.run.status()
  }

  iteration(): number {
    return this.run.iteration()
  }

  summary(): RunSummary {
    return this.run.summary()
  }

  private look(): void {
    const now = this.run.summary()
    this.met = this.stops.filter((stop) => isMet(stop, this.before, now))
    this.before = now
  }
}

/** Whether a stop was met between two moments of a run. */
function isMet(stop: Stop, before: RunSummary, now: RunSummary): boolean {
  const [found, better] = [before.iteration_of_best, now.iteration_of_best]
  switch (stop.when) {
    case 'first-path':
      return found === null && better !== null
    case 'better-path':
      return found !== null && better !== found
    case 'panel-ends':
      return before.status === 'running' && now.status !== 'running'
    // A search has contours where colonies have iterations: nobody asked about those.
    case 'iteration':
      return (
        now.iteration_budget !== null &&
        before.iteration < stop.iterations &&
        now.iteration >= stop.iterations
      )
    case 'stagnation':
      return (
        now.iteration_budget !== null &&
        better !== null &&
        since(before) < stop.iterations &&
        since(now) >= stop.iterations
      )
  }
}

const since = ({ iteration, iteration_of_best }: RunSummary) =>
  iteration_of_best === null ? 0 : iteration - iteration_of_best

/** Takes one run towards targets, as a Stepper does, unless it meets a stop first. */
export class StopWatch {
  private readonly watched: Watched
  private readonly stepper: Stepper

  constructor(run: Steppable, now: () => number) {
    this.watched = new Watched(run)
    this.stepper = new Stepper(this.watched, now)
  }

  /** The stops that were met; a run that has met one is where its round ends. */
  advance(target: Target, sliceMs: number, stops: Stop[]): { reached: boolean; met: Stop[] } {
    this.watched.begin(stops)
    const reached = this.stepper.advance(target, sliceMs)
    return { reached, met: this.watched.met }
  }
}
