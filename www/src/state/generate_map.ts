/** Maps made by seed, in the place of the one on show. */
import type { Generator } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { t } from '../i18n'
import { heightsOf } from '../model/height_bytes'
import type { Scenario } from '../model/session'
import { settleGoals } from '../model/settle_ends'
import { plainTerrain } from '../model/terrain'
import { setScenario } from './scenarios'
import { suitSpeed } from './speed'
import { scenario } from './store'

/** One step to undo. */
export async function generateMap(
  kind: Generator,
  width: number,
  height: number,
  seed: number,
  density: number,
): Promise<void> {
  const made = await tools.generate(kind, width, height, seed, density)
  const now = scenario.peek()
  if (!now) return
  const { cells, start, goal } = made
  const goals = settleGoals(now.spec.goals, now.spec, { width, height, cells, start, goal })
  const heights = heightsOf(made.heights)
  const { terrain: _, world: __, resolution, ...kept } = now.spec
  const generated: Scenario = {
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
    },
    cells,
    heights,
    origin: { generator: kind, seed, density },
  }
  suitSpeed(generated)
  setScenario(generated, { undoable: true })
}
