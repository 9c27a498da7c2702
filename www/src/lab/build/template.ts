/** Takes a comparison as the draft of another one: its maps, entries, seeds and budget. */
import type { AblationRole, Entry } from '@pkg/formicarium'
import { tools } from '../../engine/tools'
import type { MapOfQuestion } from '../../model/comparison'
import type { DraftEntry } from '../../model/draft'
import { toScenario } from '../../state/imported'
import type { OpenComparison } from '../store/signals'
import { fillWith } from './draft'
import { usualLabel } from './labels'

export async function takeAsTemplate({ question, maps, outline }: OpenComparison): Promise<void> {
  const { entries, seeds, budget = null } = question
  const roles = outline.ablation_roles
  const full = roles.findIndex((role) => role?.kind === 'full')
  fillWith({
    maps: await Promise.all(maps.map(opened)),
    entries: entries.flatMap((entry, at) => drafted(entry, roles[at] ?? null)),
    seeds,
    budget,
    ablated: entries[full]?.label ?? null,
  })
}

async function opened(map: MapOfQuestion) {
  const imported = await tools.importMap(new TextEncoder().encode(JSON.stringify(map)), map.name)
  return { name: map.name, scenario: toScenario(imported, map.name) }
}

/** Entries that cannot be run here, such as imported results, are left out. */
function drafted(
  { id, label, planner, preset = null, set = {} }: Entry,
  ablation: AblationRole | null,
): Omit<DraftEntry, 'key'>[] {
  if (!planner) return []
  const draft = { planner, preset, params: set, id, ablation }
  return [{ ...draft, label: label === usualLabel(draft) ? null : label }]
}
