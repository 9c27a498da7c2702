/** What the engine knows besides its planners, before any engine has started: the build asks the whole engine (`xtask/src/facts.mjs`). */
import facts from '@pkg/facts.json'
import type { Catalog, Formats } from '@pkg/formicarium'

/** Bytes a cell that a planner holds with its defaults, and what comes on top of them: see `xtask/src/facts.mjs`, which measures it. */
export interface Held {
  cell: number
  /** For each more of a parameter than is usual. */
  by: Record<string, { usual: number; each: number }>
  /** For each goal but the first. */
  goal: number
  /** For each level by slices. */
  level: number
}

export type Facts = Pick<Catalog, 'layers' | 'limits' | 'grounds' | 'generators'> & {
  formats: Formats
  /** By planner; null for one that knows small maps alone. */
  memory: Record<string, Held | null>
}

/** All of it, for functions that can be asked about others. */
export const FACTS = facts as Facts

export const { layers, limits, grounds, generators, formats, memory } = FACTS
