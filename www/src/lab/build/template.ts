/** Takes a comparison as the draft of another one: its maps, entries, seeds and budget. */
import type { AblationRole, Entry } from '@pkg/formicarium'
import { batch } from '@preact/signals'
import { tools } from '../../engine/tools'
import { t } from '../../i18n/lab'
import type { MapOfQuestion } from '../../model/comparison'
import type { DraftEntry } from '../../model/draft'
import { toScenario } from '../../state/imported'
import { labelsOf } from '../../words/planner_words'
import type { OpenComparison } from '../store/signals'
import { fillWith, note, title } from './draft'
import { titleOf } from './labels'

export async function takeAsTemplate({ question, maps, outline }: OpenComparison): Promise<void> {
  const { entries, seeds, budget = null } = question
  const roles = outline.ablation_roles
  const full = roles.findIndex((role) => role?.kind === 'full')
  fillWith({
    maps: await Promise.all(maps.map(opened)),
    entries: unlabelled(entries.flatMap((entry, at) => drafted(entry, roles[at] ?? null))),
    seeds,
    budget,
    ablated: entries[full]?.label ?? null,
  })
  // What a paper asks is not what the reader makes of it.
  if (question.paper) return
  batch(() => {
    if (question.title !== titleOf()) title.value = question.title
    if (!isUsual(question.asks)) note.value = question.asks
  })
}

const isUsual = (asks: string) =>
  [t('lab.build.asks'), t('lab.build.asks', { lng: 'en' })].includes(asks)

async function opened(map: MapOfQuestion) {
  const imported = await tools.importMap(new TextEncoder().encode(JSON.stringify(map)), map.name)
  return { name: map.name, scenario: toScenario(imported, map.name) }
}

/** Entries that cannot be run here, such as imported results, are left out. */
function drafted(
  { id, label, planner, preset = null, set = {} }: Entry,
  ablation: AblationRole | null,
): Omit<DraftEntry, 'key'>[] {
  return planner ? [{ planner, preset, params: set, id, ablation, label }] : []
}

/** Labels that entries have by themselves are not the reader's. */
function unlabelled(drafts: Omit<DraftEntry, 'key'>[]): Omit<DraftEntry, 'key'>[] {
  const usual = labelsOf(drafts.map((draft) => ({ ...draft, label: null })))
  return drafts.map((draft, at) => (draft.label === usual[at] ? { ...draft, label: null } : draft))
}
