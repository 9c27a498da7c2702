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

/** Whether a map is more than the core knows: no terrain, no weighted ground, no robot, no measures of driving, no walls that change. */
export const asksForWhole = ({
  heights,
  factors,
  spec,
}: Pick<RunSetup, 'heights' | 'factors' | 'spec'>): boolean =>
  (heights ??
    factors ??
    spec.robot ??
    spec.changes ??
    spec.vehicle.energy ??
    spec.vehicle.smoothing) != null

/** The build for a run. */
export const buildForRun = (setup: RunSetup): Build =>
  asksForWhole(setup) ? 'whole' : buildFor(setup.planner)

/** The smallest build that can run the planner on a plain map, if any can. */
export const buildFor = (planner: string): Build => (coreIds.has(planner) ? 'core' : 'whole')
