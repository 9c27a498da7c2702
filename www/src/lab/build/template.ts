/** Takes a comparison as the draft of another one: its maps, entries, seeds and budget. */
import { tools } from '../../engine/tools'
import type { Entry, MapOfQuestion, Question } from '../../model/comparison'
import type { DraftEntry } from '../../model/draft'
import { toScenario } from '../../state/files'
import type { OpenComparison } from '../store/signals'
import { fillWith } from './draft'
import { usualLabel } from './labels'

export async function takeAsTemplate({ question, maps }: OpenComparison): Promise<void> {
  fillWith({
    maps: await Promise.all(maps.map(opened)),
    entries: question.entries.flatMap(drafted),
    seeds: question.seeds,
    budget: question.budget ?? null,
    ablated: ablatedOf(question),
  })
}

async function opened(map: MapOfQuestion) {
  const imported = await tools.importMap(new TextEncoder().encode(JSON.stringify(map)), map.name)
  return { name: map.name, scenario: toScenario(imported, map.name) }
}

/** Entries that cannot be run here, such as imported results, are left out. */
function drafted({ id, label, planner, preset, set }: Entry): Omit<DraftEntry, 'key'>[] {
  if (!planner) return []
  const draft = { planner, preset: preset ?? null, params: set ?? {}, id }
  return [{ ...draft, label: label === usualLabel(draft) ? null : label }]
}

function ablatedOf({ entries }: Question): string | null {
  return entries.find(({ id }) => id === 'full')?.label ?? null
}
