// Writes facts.json: the catalog of the whole engine without its planners, the formats of documents, and what planners hold in memory.
// Argument: the engine's folder.
import { readFileSync, writeFileSync } from 'node:fs'
import { pathToFileURL } from 'node:url'

const [, folder] = process.argv
const module = new WebAssembly.Module(readFileSync(`${folder}/formicarium_bg.wasm`))
let instances = 0

/** An instance of its own: what one has grown to, it keeps. */
async function instance() {
  const engine = await import(`${pathToFileURL(`${folder}/formicarium.js`).href}?${++instances}`)
  return { engine, memory: engine.initSync({ module }).memory }
}

const { engine } = await instance()
const { format, planners, ...facts } = engine.catalog()

/** Moves after which a planner has all its tables. */
const MOVES = 300
const plain = engine.import_map(new TextEncoder().encode('0 0\n0 0\n'), 'plain').spec

/** What a planner holds on an empty map: bytes a cell of its own tables, and by which the instance has grown; null where it refuses. */
async function asked(planner, side, { params = {}, goals = 1, levels = 0 }) {
  const { engine, memory } = await instance()
  const before = memory.buffer.byteLength
  const goal = (i) => ({ ...plain.goals[0], at: [side - 1, side - 1 - 9 * i] })
  const spec = { ...plain, width: side, height: side, start: [0, 0], goals: Array.from({ length: goals }, (_, i) => goal(i)) }
  const slices = { level: 1, levels, max_aside: 2, max_climb: 2, start_level: 1, goal_level: 1, measure: 'cost' }
  if (levels > 0) spec.terrain = { vertical_unit: 1, slices }
  const cells = side * side
  try {
    const run = new engine.Run(spec, new Uint8Array(cells), levels > 0 ? new Float32Array(cells) : null, null, planner, params, 1)
    run.advance('move', MOVES)
    const grown = (memory.buffer.byteLength - before) / cells
    run.keep_snapshots(0)
    return { grown, own: run.snapshots()[1] / cells }
  } catch (refused) {
    if (refused.kind === undefined) throw refused
    return null
  }
}

/**
 * Bytes a cell that a planner holds: `cell` with its defaults and the dearest of each of its choices, and on top of it for each more of a
 * parameter (`by`, with what is usual of it), for each further goal and for each level by slices. Null for one that knows small maps alone.
 */
async function held({ id, params, grounds }) {
  const levels = grounds.includes('plane') ? 0 : 10
  const dearest = {}
  const own = async (more = {}) => {
    const found = await asked(id, 36, { levels, ...more, params: { ...dearest, ...more.params } })
    return found?.own ?? null
  }
  let usual = await own()
  for (const { key, kind } of params) {
    if (kind.type !== 'choice') continue
    for (const option of kind.options) {
      const found = (await own({ params: { [key]: option.id ?? option } })) ?? 0
      if (found <= usual + 1) continue
      usual = found
      dearest[key] = option.id ?? option
    }
  }
  // Large enough that the 64 KB by which memory grows hardly count.
  const whole = await asked(id, 96, { levels, params: dearest })
  if (whole === null) return null
  const told = { cell: whole.grown, by: {}, goal: 0, level: 0 }
  for (const { key, kind, default: few } of params) {
    if (kind.type !== 'integer' || few < 2) continue
    const many = Math.min(kind.max, 2 * few)
    const each = (((await own({ params: { [key]: many } })) ?? 0) - usual) / (many - few)
    if (each > 0.05) told.by[key] = { usual: few, each: rounded(each) }
  }
  const goals = (await asked(id, 36, { levels, goals: 3 }))?.own
  if (goals !== undefined) told.goal = rounded((goals - (await asked(id, 36, { levels })).own) / 2)
  if (grounds.includes('slices')) told.level = rounded(((await own({ levels: 20 })) - (await own({ levels: 10 }))) / 10)
  told.cell = rounded(whole.grown - levels * told.level)
  return told
}

const rounded = (bytes) => Math.max(0, Math.ceil(bytes * 10) / 10)

const memory = {}
for (const planner of planners) memory[planner.id] = await held(planner)
const text = JSON.stringify({ ...facts, formats: engine.formats(), memory }, null, 2)
writeFileSync(`${folder}/facts.json`, `${text}\n`)
