/** Fetches the papers' scenarios: the very files that the recorded comparisons run on. */
import { tools } from '../engine/tools'
import { heightsOf } from '../model/height_bytes'
import type { Scenario } from '../model/session'

const texts = import.meta.glob<string>('../../../experiments/maps/*.json', {
  query: '?raw',
  import: 'default',
})

export async function paperScenario(file: string): Promise<Scenario> {
  const fetched = texts[`../../../experiments/maps/${file}.json`]
  if (!fetched) throw new Error(`there is no map ${file}`)
  const bytes = new TextEncoder().encode(await fetched())
  const { spec, cells, heights } = await tools.importMap(bytes, `${file}.json`)
  return { spec, cells, heights: heightsOf(heights), origin: null }
}
