/** Maps that the engine makes: looked at before they are opened. Fetched with the dialog that asks for them. */
import type { Generator } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { t } from '../i18n'
import { numbersOf } from '../model/cell_numbers'
import type { Scenario } from '../model/session'
import { settleGoals } from '../model/settle_goals'
import { plainTerrain } from '../model/terrain'
import { setScenario } from './scenarios'
import { suitSpeed } from './speed'
import { scenario } from './store'

export interface GeneratorCall {
  kind: Generator
  width: number
  height: number
  seed: number
  /** Share of obstacles; of a terrain its roughness. */
  density: number
}

/** What the call makes, with the goals and rules of the map on show; null while there is none. */
export async function generatedMap(call: GeneratorCall): Promise<Scenario | null> {
  const { kind, width, height, seed, density } = call
  const made = await tools.generate(kind, width, height, seed, density)
  const now = scenario.peek()
  if (!now) return null
  const { cells, start, goal } = made
  const goals = settleGoals(now.spec.goals, now.spec, { width, height, cells, start, goal })
  const heights = numbersOf(made.heights)
  const { terrain: _, world: __, resolution, robot, ...kept } = now.spec
  return {
    spec: {
      ...kept,
      name: t('maps.generatedName', { kind: t(`maps.kind.${kind}`), seed }),
      width,
      height,
      start,
      goals,
      // The size of a cell belongs to the ground; from plane to plane it is the reader's.
      resolution: heights || now.heights ? made.resolution : resolution,
      ...(heights && { terrain: plainTerrain() }),
      // On a terrain nothing says what a step costs near obstacles.
      ...(robot && { robot: heights ? { radius: robot.radius } : robot }),
    },
    cells,
    heights,
    factors: null,
    origin: { generator: kind, seed, density },
  }
}

export function openGenerated(generated: Scenario): void {
  suitSpeed(generated)
  setScenario(generated, { undoable: true })
}
