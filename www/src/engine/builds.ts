/**
 * The two builds of the engine: the core, which a visitor waits for, with the planners of a first visit; and the whole one, with
 * every planner, file formats and generators. A run gives the same digest in both.
 */
import type { Catalog } from '@pkg/formicarium'
import type { RunSetup } from '../model/messages'

export type Build = 'core' | 'whole'

const coreIds = new Set<string>()

/** Tells which planners the core has. To be called before the first run is loaded. */
export function noteCore({ planners }: Pick<Catalog, 'planners'>): void {
  for (const { id } of planners) coreIds.add(id)
}

/** The build for a run: the core knows no terrains, and no walls that change. */
export const buildForRun = ({ planner, heights, spec }: RunSetup): Build =>
  buildFor({ planner, onTerrain: heights !== null || spec.changes !== undefined })

/** The smallest build that can run the planner, if any can. The core draws no terrains. */
export function buildFor({ planner, onTerrain }: { planner: string; onTerrain: boolean }): Build {
  return coreIds.has(planner) && !onTerrain ? 'core' : 'whole'
}
