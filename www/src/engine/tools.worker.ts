/** The engine's side of tools.ts: answers one call at a time, in order. */
import * as engine from '@pkg/formicarium'
import { toEngineError } from './errors'
import type { ToolCalls, ToolReply, ToolRequest } from './tools'

const calls: ToolCalls = {
  catalog: () => engine.catalog(),
  version: () => engine.version(),
  importMap: (bytes, name) => engine.import_map(bytes, name),
  importScen: (bytes) => engine.import_scen(bytes),
  sniff: (bytes, name) => engine.sniff(bytes, name),
  exportMap: (spec, cells, format) => engine.export_map(spec, cells, format),
  generate: (kind, width, height, seed, density) =>
    engine.generate(kind, width, height, seed, density),
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

function answer(request: Exclude<ToolRequest, { kind: 'init' }>): ToolReply {
  try {
    const call = calls[request.call] as (...args: unknown[]) => unknown
    return { id: request.id, ok: true, value: call(...request.args) }
  } catch (thrown) {
    return { id: request.id, ok: false, error: toEngineError(thrown) }
  }
}

self.onmessage = (event: MessageEvent<ToolRequest>) => {
  const request = event.data
  if (request.kind === 'init') engine.initSync({ module: request.module })
  else self.postMessage(answer(request))
}
