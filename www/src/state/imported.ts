/** What the engine read from a file, as a scenario. */
import type { Imported } from '@pkg/formicarium'
import { numbersOf } from '../model/cell_numbers'
import type { Scenario } from '../model/session'

export function toScenario({ spec, cells, heights, factors }: Imported, name: string): Scenario {
  return {
    spec: { ...spec, name: spec.name || name },
    cells,
    heights: numbersOf(heights),
    factors: numbersOf(factors),
    origin: null,
  }
}
