/**
 * version.json beside the page: of which engine it is, and what the planners give on small questions, as digests. From two of them a page
 * can tell which planners a newer version computes differently (src/offline).
 */
import { readFileSync } from 'node:fs'
import { pathToFileURL } from 'node:url'
import type { Plugin } from 'vite'
import type * as Engine from '../pkg/formicarium.js'

/** `version.json`. */
export interface Version {
  engine: string
  /** By planner. */
  results: Record<string, string>
}

/** Enough for searches to end, and for the second half of those that have two. */
const ITERATIONS = 150
const SIDE = 12
const SEED = 1

/** `pkg`: the folder of the whole engine. */
export function versionOfPage(pkg: string): Plugin {
  return {
    name: 'formicarium:version',
    apply: 'build',
    async generateBundle() {
      const source = JSON.stringify(await versionOf(pkg))
      this.emitFile({ type: 'asset', fileName: 'version.json', source })
    },
  }
}

async function versionOf(pkg: string): Promise<Version> {
  const engine: typeof Engine = await import(pathToFileURL(`${pkg}/formicarium.js`).href)
  const module = new WebAssembly.Module(readFileSync(`${pkg}/formicarium_bg.wasm`))
  engine.initSync({ module })
  const results: Version['results'] = {}
  for (const planner of engine.catalog().planners) results[planner.id] = digestOf(engine, planner)
  return { engine: engine.version(), results }
}

/** One for a planner with its defaults and with each of its presets, on a plane or by slices. */
function digestOf(engine: typeof Engine, { id, grounds, presets }: Engine.CatalogEntry): string {
  const question = grounds.includes('plane') ? onPlane(engine) : bySlices(engine)
  const digests = [{}, ...presets.map(({ values }) => values)].map((params) => {
    const { spec, cells, heights } = question
    try {
      const run = new engine.Run(spec, cells, heights, null, id, params, SEED)
      run.advance('iteration', ITERATIONS)
      return run.summary().digest
    } catch (refused) {
      return (refused as Engine.EngineError).kind
    }
  })
  return digests.join(' ')
}

interface Question {
  spec: Engine.ScenarioSpec
  cells: Uint8Array
  heights: Float32Array | null
}

function onPlane(engine: typeof Engine): Question {
  const plain = engine.import_map(new TextEncoder().encode('0 0\n0 0\n'), 'plain').spec
  const at: [number, number] = [SIDE - 1, SIDE - 1]
  const goals = plain.goals.map((goal) => ({ ...goal, at }))
  const spec = { ...plain, width: SIDE, height: SIDE, start: [0, 0] as [number, number], goals }
  const { cells } = engine.generate('random', SIDE, SIDE, SEED, 0.2)
  const free = Uint8Array.from(cells)
  free[0] = 0
  free[free.length - 1] = 0
  return { spec, cells: free, heights: null }
}

function bySlices(engine: typeof Engine): Question {
  const { spec } = onPlane(engine)
  const slices = {
    level: 1,
    levels: 8,
    max_aside: 2,
    max_climb: 2,
    start_level: 1,
    goal_level: 1,
    measure: 'cost' as const,
  }
  const heights = Float32Array.from({ length: SIDE * SIDE }, (_, i) => (i * 7) % 5)
  heights[0] = 0
  heights[heights.length - 1] = 0
  const cells = new Uint8Array(SIDE * SIDE)
  return { spec: { ...spec, terrain: { vertical_unit: 1, slices } }, cells, heights }
}
