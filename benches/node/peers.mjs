// The engine as WebAssembly in node: A* beside the npm package `pathfinding`, and Ant System's moves per second.
//
//   cargo xtask wasm && FORMICARIUM_DATA=path/to/data node benches/node/peers.mjs
//
// One process, one core, medians; read ratios, times drift with the machine. `--quick` only tries whether it runs: a few lines, one round,
// and a map made by seed where there is no data.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { performance } from 'node:perf_hooks'
import { fileURLToPath } from 'node:url'

const root = new URL('../../', import.meta.url)
const quick = process.argv.includes('--quick')
const data = process.env.FORMICARIUM_DATA
if (!data && !quick) {
  console.error('set FORMICARIUM_DATA to the folder that holds movingai/')
  process.exit(2)
}
const engine = await import(new URL('pkg/formicarium.js', root))
engine.initSync({ module: readFileSync(fileURLToPath(new URL('pkg/formicarium_bg.wasm', root))) })
const PF = createRequire(new URL('www/package.json', root))('pathfinding')

const ROUNDS = quick ? 1 : 3
const LINES = quick ? 3 : 50
const ITERATIONS = quick ? 3 : 60

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1]
const timed = (work) => {
  const begin = performance.now()
  const result = work()
  return [performance.now() - begin, result]
}

/** A map and its list of scenarios; without data one that is made by seed, with the one scenario that the generator knows. */
function read(name) {
  if (data) {
    const file = (name) => readFileSync(`${data}/movingai/${name}`)
    return { map: engine.import_map(file(name), name), lines: engine.import_scen(file(`${name}.scen`)).lines }
  }
  const [width, height] = [128, 128]
  const { cells, resolution, start, goal } = engine.generate('random', width, height, 1, 0.2)
  const spec = {
    name,
    width,
    height,
    resolution,
    movement: { moves: 8, corner_rule: 'both-free' },
    start,
    goals: [{ at: goal, name: '', area: 1, strength: 1, danger: 1 }],
    vehicle: { speed: 1, seconds_per_turn: 0 },
  }
  const optimal = engine.reference(spec, cells, null, 'length').value
  return { map: { spec, cells }, lines: [{ start, goal, optimal }] }
}

/** A* on `count` lines spread over the .scen file: both engines, same rule, same lines, some rounds, best time of each line. */
function astar(mapName, count) {
  const { map, lines } = read(mapName)
  const { width, height } = map.spec
  const rows = Array.from({ length: height }, (_, y) => Array.from(map.cells.subarray(y * width, (y + 1) * width)))
  const grid = new PF.Grid(rows)
  const finder = new PF.AStarFinder({
    diagonalMovement: PF.DiagonalMovement.OnlyWhenNoObstacles,
    heuristic: PF.Heuristic.octile,
  })
  const picked = Array.from({ length: count }, (_, i) => lines[Math.floor(((i + 0.5) * lines.length) / count)])
  const ours = []
  const whole = []
  const npm = []
  let off = 0
  for (const { start, goal, optimal } of picked) {
    const best = { ours: Infinity, whole: Infinity, npm: Infinity }
    for (let round = 0; round < ROUNDS; round++) {
      const spec = { ...map.spec, start, goals: [{ at: goal, name: '', area: 1, strength: 1, danger: 1 }] }
      const [setup, run] = timed(() => new engine.Run(spec, map.cells, null, 'astar', {}, 0))
      const [search] = timed(() => run.advance('iteration', 1e9))
      const length = run.summary().metrics?.length ?? NaN
      if (Math.abs(length - optimal) > 1e-3) off++
      run.free()
      const clone = grid.clone()
      const [peer] = timed(() => finder.findPath(start[0], start[1], goal[0], goal[1], clone))
      best.ours = Math.min(best.ours, search)
      best.whole = Math.min(best.whole, search + setup)
      best.npm = Math.min(best.npm, peer)
    }
    ours.push(best.ours)
    whole.push(best.whole)
    npm.push(best.npm)
  }
  const ms = (v) => `${v.toFixed(3)} ms`
  console.log(`A* on ${mapName} (${width}×${height}), median of ${count} scenario lines, ${off} lengths off the listed optimum`)
  console.log(`  formicarium (wasm)              ${ms(median(ours))}`)
  console.log(`  formicarium with its set-up     ${ms(median(whole))}`)
  console.log(`  npm pathfinding A*              ${ms(median(npm))}`)
  console.log(`  npm / formicarium, line by line ${median(npm.map((v, i) => v / ours[i])).toFixed(1)}`)
}

/** Ant System, 50 ants, defaults, corner to corner of the largest line of the .scen. */
function antSystem(mapName) {
  const { map, lines } = read(mapName)
  const longest = lines.at(-1)
  const spec = { ...map.spec, start: longest.start, goals: [{ at: longest.goal, name: '', area: 1, strength: 1, danger: 1 }] }
  const rates = []
  for (let round = 0; round < ROUNDS + 2; round++) {
    const run = new engine.Run(spec, map.cells, null, 'ant-system', { iterations: 100000 }, 1)
    run.advance('iteration', 5)
    const before = run.summary().effort.ant_moves
    const [ms] = timed(() => run.advance('iteration', ITERATIONS))
    rates.push((run.summary().effort.ant_moves - before) / ms / 1000)
    run.free()
  }
  console.log(`Ant System on ${mapName}, 50 ants: ${median(rates).toFixed(1)} million ant moves per second`)
}

astar('32room_000.map', LINES)
antSystem('arena2.map')
