/** How much memory a race is going to take, before any of it is taken. */
import type { ScenarioSpec } from '@pkg/formicarium'
import { FACTS, type Facts } from './facts'
import { KEPT_BYTES } from './kept_bytes'
import type { PanelSetup } from './session'

/** More than this is taken only when somebody asks for it: no link starts it by itself. */
export const UNASKED_BYTES = 512 * 1024 * 1024
/** More than this is refused: a tab ends before it has so much, and an engine at 4 GiB. */
export const MOST_BYTES = 3 * 1024 * 1024 * 1024
/** A panel's copy of the map, its layer, and the picture of both: on either side of the engine. */
const PAINTED_BYTES = 16

type Racing = Pick<PanelSetup, 'planner' | 'params' | 'result'>

/** Bytes that these planners hold on a map of this kind, each in a panel of its own; recorded runs are repeated beside them, one at a time. */
export function memoryOf(
  spec: ScenarioSpec,
  panels: readonly Racing[],
  facts: Facts = FACTS,
): number {
  const cells = spec.width * spec.height
  const each = panels.map((panel) => {
    const tables = cells * tablesOf(spec, panel, facts)
    // A snapshot larger than what is there for all of them is not kept.
    return cells * PAINTED_BYTES + tables + Math.min(tables, KEPT_BYTES)
  })
  const repeated = panels.map((panel) => (panel.result ? cells * tablesOf(spec, panel, facts) : 0))
  return each.reduce((sum, bytes) => sum + bytes, Math.max(0, ...repeated))
}

/** Bytes a cell. A planner that is not known is not run. */
function tablesOf(spec: ScenarioSpec, { planner, params }: Racing, { memory }: Facts): number {
  const held = memory[planner]
  if (!held) return 0
  const more = Object.entries(held.by).map(([key, { usual, each }]) => {
    const asked = params[key]
    return typeof asked === 'number' ? each * Math.max(0, asked - usual) : 0
  })
  const goals = held.goal * (spec.goals.length - 1)
  const levels = held.level * (spec.terrain?.slices?.levels ?? 0)
  return more.reduce((sum, bytes) => sum + bytes, held.cell + goals + levels)
}
