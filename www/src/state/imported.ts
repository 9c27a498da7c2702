/** What the engine read from a file, as a scenario. */
import type { Imported } from '@pkg/formicarium'
import { heightsOf } from '../model/height_bytes'
import type { Scenario } from '../model/session'

export function toScenario({ spec, cells, heights }: Imported, name: string): Scenario {
  return {
    spec: { ...spec, name: spec.name || name },
    cells,
    heights: heightsOf(heights),
    origin: null,
  }
}
