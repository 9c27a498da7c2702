/** Fetches the papers' scenarios: the very files that the recorded comparisons run on. */
import { tools } from '../engine/tools'
import { numbersOf } from '../model/cell_numbers'
import type { Scenario } from '../model/session'

/** Not those whose names end with a number: the terrains and the suite come with their questions. */
const texts = import.meta.glob<string>(
  ['../../../experiments/maps/*.json', '!../../../experiments/maps/*-[0-9][0-9].json'],
  { query: '?raw', import: 'default' },
)

export async function paperScenario(file: string): Promise<Scenario> {
  const fetched = texts[`../../../experiments/maps/${file}.json`]
  if (!fetched) throw new Error(`there is no map ${file}`)
  const bytes = new TextEncoder().encode(await fetched())
  const { spec, cells, heights, factors } = await tools.importMap(bytes, `${file}.json`)
  return {
    spec,
    cells,
    heights: numbersOf(heights),
    factors: numbersOf(factors),
    origin: null,
  }
}
