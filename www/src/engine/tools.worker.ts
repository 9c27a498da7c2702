/** The core engine's side of tools.ts. */
import * as engine from '@pkg/core/formicarium'
import { answerCalls } from './answer'
import type { ToolCalls } from './tools'

const calls: ToolCalls = {
  catalog: () => engine.catalog(),
  version: () => engine.version(),
  check: (spec, cells) => engine.check_scenario(spec, cells),
  proposeSeed: () => engine.propose_seed(),
  optimum: (spec, cells) => {
    const best = runToEnd(
      { spec, cells, planner: 'astar', params: {}, seed: 1 },
      Number.POSITIVE_INFINITY,
    )
    return best.metrics?.length ?? Number.POSITIVE_INFINITY
  },
  repeat: (setup, iterations) => runToEnd(setup, iterations),
}

/** Runs until `iterations` are complete or the planner has ended by itself. */
function runToEnd(
  setup: Parameters<ToolCalls['repeat']>[0],
  iterations: number,
): engine.RunSummary {
  const run = new engine.Run(setup.spec, setup.cells, setup.planner, setup.params, setup.seed)
  try {
    while (run.status() === 'running' && run.iteration() < iterations) run.advance('iteration', 1)
    return run.summary()
  } finally {
    run.free()
  }
}

answerCalls(calls, (module) => engine.initSync({ module }))
