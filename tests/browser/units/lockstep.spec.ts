import { expect, test } from '@playwright/test'
import { planRound, type Standing } from '../../../www/src/engine/plan_round'
import { SPEEDS, type Speed, type Sync } from '../../../www/src/model/session'
import { Crowd } from '../../../www/src/worker/crowd'
import { type Steppable, Stepper } from '../../../www/src/worker/stepper'

/** A run whose iterations take a fixed number of moves, on a clock that each move advances by `moveMs`. */
class FakeRun implements Steppable {
  moves = 0
  constructor(
    readonly movesPerIteration: number,
    readonly ants: number,
    readonly budget: number,
    readonly clock = { ms: 0 },
    readonly moveMs = 0.01,
  ) {}

  advance(by: 'move' | 'iteration', count: number) {
    for (let i = 0; i < count && this.status() === 'running'; i++) {
      const steps =
        by === 'move' ? 1 : this.movesPerIteration - (this.moves % this.movesPerIteration)
      this.moves += steps
      this.clock.ms += steps * this.moveMs
    }
    return this.status()
  }

  iteration() {
    return Math.floor(this.moves / this.movesPerIteration)
  }

  status() {
    return this.iteration() >= this.budget ? ('budget-spent' as const) : ('running' as const)
  }

  summary() {
    const paths = this.iteration() * this.ants
    return { effort: { constructed_paths: paths } } as ReturnType<Steppable['summary']>
  }
}

const speed = (id: string): Speed => SPEEDS.find((each) => each.id === id) as Speed

function standing(run: FakeRun, id: number): Standing {
  return {
    id,
    iteration: run.iteration(),
    paths: run.iteration() * run.ants,
    ants: run.iteration() ? run.ants : 0,
  }
}

/** Plays rounds and reports after each what all runs have reached. */
function play(
  runs: FakeRun[],
  sync: Sync,
  at: Speed,
  rounds: number,
  look: (standings: Standing[]) => void,
): void {
  const steppers = runs.map((run) => new Stepper(run, () => run.clock.ms))
  for (let round = 0; round < rounds; round++) {
    const running = runs.flatMap((run, id) =>
      run.status() === 'running' ? [standing(run, id)] : [],
    )
    if (running.length === 0) return
    for (const [id, target] of planRound(running, at, sync, 4)) {
      while (!steppers[id]?.advance(target, 8));
    }
    look(runs.map(standing))
  }
}

test.describe('lockstep', () => {
  test('by moves: every panel makes the same number', () => {
    const runs = [new FakeRun(7, 10, 1000), new FakeRun(31, 50, 1000)]
    play(runs, 'moves', speed('moves-16'), 50, () => expect(runs[0]?.moves).toBe(runs[1]?.moves))
    expect(runs[0]?.moves).toBe(800)
  })

  for (const id of ['move', 'moves-64', 'iteration', 'iterations-4', 'max']) {
    test(`by iterations at speed ${id}: nobody begins the next before all have reached the last`, () => {
      const runs = [new FakeRun(3, 10, 1000), new FakeRun(40, 50, 1000), new FakeRun(1, 0, 20)]
      const batch = { move: 1, 'moves-64': 1, iteration: 1, 'iterations-4': 4, max: 4 }[id] ?? 1
      play(runs, 'iterations', speed(id), 1200, (standings) => {
        const running = standings
          .filter((_, i) => runs[i]?.status() === 'running')
          .map((s) => s.iteration)
        if (running.length > 1)
          expect(Math.max(...running) - Math.min(...running)).toBeLessThanOrEqual(batch)
      })
      expect(runs[2]?.status()).toBe('budget-spent')
      expect(runs[1]?.iteration()).toBeGreaterThan(5)
    })
  }

  test('by paths: a small colony runs several iterations for one of a large one', () => {
    const runs = [new FakeRun(5, 10, 10_000), new FakeRun(20, 50, 10_000)]
    play(runs, 'paths', speed('iteration'), 60, () => {})
    const [few, many] = runs.map((run, id) => standing(run, id).paths)
    expect(Math.abs((few ?? 0) - (many ?? 0))).toBeLessThanOrEqual(50)
    expect(many).toBeGreaterThan(1000)
  })

  test('by time: each panel gets its slice, however much it does in it', () => {
    const runs = [
      new FakeRun(5, 10, 1e9, { ms: 0 }, 0.001),
      new FakeRun(5, 10, 1e9, { ms: 0 }, 0.01),
    ]
    play(runs, 'time', speed('max'), 10, () => {})
    for (const run of runs) expect(Math.abs(run.clock.ms - 80)).toBeLessThan(5)
  })

  test('a long iteration never overruns its slice by more than a look at the clock', () => {
    const run = new FakeRun(100_000, 50, 10, { ms: 0 }, 0.05)
    const stepper = new Stepper(run, () => run.clock.ms)
    let ticks = 0
    for (
      let before = 0;
      !stepper.advance({ kind: 'until-iteration', iteration: 2 }, 8);
      before = run.clock.ms
    ) {
      expect(run.clock.ms - before).toBeLessThan(8 + 16 * 0.05 + 0.01)
      ticks++
    }
    expect(run.iteration()).toBe(2)
    expect(run.moves).toBe(200_000)
    expect(ticks).toBeGreaterThan(1000)
  })
})

test.describe('crowd', () => {
  test('ants keep their identity and heading when others die', () => {
    const crowd = new Crowd()
    crowd.update(Uint32Array.of(5, 5, 9, 9, 1, 1), true)
    const [first, , third] = [...crowd]
    crowd.update(Uint32Array.of(6, 5, 1, 2), true)
    const after = [...crowd]
    expect(after.map((ant) => ant.id)).toEqual([first?.id, third?.id])
    expect(after[0]?.heading).toBe(0)
    expect(after[1]?.heading).toBeCloseTo(Math.PI / 2)
  })

  test('a new iteration hatches new ants at the start', () => {
    const crowd = new Crowd()
    crowd.update(Uint32Array.of(20, 20), true)
    crowd.update(Uint32Array.of(0, 0, 0, 0), true)
    const ants = [...crowd]
    expect(ants).toHaveLength(2)
    expect(ants.every((ant) => ant.fromX === 0 && ant.fromY === 0)).toBe(true)
  })
})
