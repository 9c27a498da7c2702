/** An experiment as the beginning of another one: its maps, planners, values, seeds and budget, to be changed. */
import { tools } from '../../engine/tools'
import type { Contender, MapOfQuestion, Question } from '../../model/comparison'
import type { DraftEntry } from '../../model/draft'
import { toScenario } from '../../state/files'
import type { Study } from '../store/signals'
import { fillWith } from './draft'
import { usualLabel } from './labels'

export async function takeAsTemplate({ question, maps }: Study): Promise<void> {
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

/** What cannot be run here cannot be changed here either. */
function drafted({ id, label, planner, preset, set }: Contender): Omit<DraftEntry, 'key'>[] {
  if (!planner) return []
  const draft = { planner, preset: preset ?? null, params: set ?? {}, id }
  return [{ ...draft, label: label === usualLabel(draft) ? null : label }]
}

function ablatedOf({ entries }: Question): string | null {
  return entries.find(({ id }) => id === 'full')?.label ?? null
}
