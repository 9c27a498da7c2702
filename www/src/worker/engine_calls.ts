/** What every tools worker does, on whichever build of the engine. */
import type * as core from '@pkg/core/formicarium'
import type { RunSetup } from '../model/messages'
import type { ToolCalls } from '../model/tool_calls'

type Engine = Pick<
  typeof core,
  'catalog' | 'version' | 'check_scenario' | 'propose_seed' | 'reference' | 'Run'
>

export function toolCalls(engine: Engine): ToolCalls {
  return {
    catalog: () => engine.catalog(),
    version: () => engine.version(),
    check: (...map) => engine.check_scenario(...map),
    proposeSeed: () => engine.propose_seed(),
    reference: (...asked) => engine.reference(...asked),
    repeat: (setup, iterations) => runToEnd(engine, setup, iterations),
  }
}

/** Runs until `iterations` are complete or the planner has ended by itself. */
function runToEnd({ Run }: Engine, setup: RunSetup, iterations: number): core.RunSummary {
  const { spec, cells, heights, factors, planner, params, seed } = setup
  const run = new Run(spec, cells, heights, factors, planner, params, seed)
  try {
    while (run.status() === 'running' && run.iteration() < iterations) run.advance('iteration', 1)
    return run.summary()
  } finally {
    run.free()
  }
}
