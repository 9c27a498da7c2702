// The engine as WebAssembly, in node and in a browser alike.

const goalAt = (at) => ({ at, name: '', area: 1, strength: 1, danger: 1 })

/** One iteration of a colony with all that it needs before, then so many more. */
export function walk(engine, { spec, cells }, { planner, params, iterations }) {
  return (seed) => {
    const begin = performance.now()
    const run = new engine.Run(spec, cells, null, null, planner, params, seed)
    run.advance('iteration', 1)
    const first = (performance.now() - begin) / 1000
    const before = run.summary().effort.ant_moves
    const next = performance.now()
    run.advance('iteration', iterations)
    const seconds = (performance.now() - next) / 1000
    const { effort, digest } = run.summary()
    run.free()
    return { first, seconds, moves: effort.ant_moves - before, digest }
  }
}

/** The lengths of shortest paths: from the cells and two ends to a number, everything included. */
export function exact(engine, { spec, cells }, { lines }) {
  const specs = lines.map(([x, y, toX, toY]) => ({
    ...spec,
    start: [x, y],
    goals: [goalAt([toX, toY])],
  }))
  return () => {
    const begin = performance.now()
    const lengths = specs.map((spec) => engine.reference(spec, cells, null, null, 'length').value)
    return { seconds: (performance.now() - begin) / 1000, lengths }
  }
}

/** The engine's contestant for a job. */
export function contestant(engine, map, job) {
  return job.work === 'walk' ? walk(engine, map, job) : exact(engine, map, job)
}
