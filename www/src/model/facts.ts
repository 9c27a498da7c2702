/** What the engine knows besides its planners, before any engine has started: the build asks the whole engine (`xtask/src/facts.mjs`). */
import facts from '@pkg/facts.json'
import type { Catalog, Formats } from '@pkg/formicarium'

export type Facts = Pick<Catalog, 'layers' | 'limits' | 'grounds' | 'generators'> & {
  formats: Formats
}

/** All of it, for functions that can be asked about others. */
export const FACTS = facts as Facts

export const { layers, limits, grounds, generators, formats } = FACTS
