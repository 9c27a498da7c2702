/** Labels of entries and the title, unless the reader has written others. */
import { computed } from '@preact/signals'
import { t } from '../../i18n/lab'
import type { DraftEntry } from '../../model/draft'
import { plannerEntry } from '../../state'
import { labelsOf, nameOf, presetName } from '../../words/planner_words'
import { uniqueId } from '../store/names'
import { ablated, entries, maps, title } from './draft'

/** What an entry is called beside the others. */
export const labelOf = (entry: DraftEntry) => labels.value.get(entry.key) ?? nameOf(entry.planner)

const labels = computed(() => {
  const all = labelsOf(entries.value)
  return new Map(entries.value.map(({ key }, at) => [key, all[at] ?? '']))
})

/** Stable ids of all entries, in their order. */
export function idsOf(all: DraftEntry[]): string[] {
  const taken = all.flatMap(({ id }) => id ?? [])
  return all.map(({ id, planner, preset }) => {
    if (id !== null) return id
    const made = uniqueId(preset ? `${planner}-${preset}` : planner, taken)
    taken.push(made)
    return made
  })
}

export function titleOf(): string {
  if (title.value !== null && title.value.trim() !== '') return title.value.trim()
  const [map, ...others] = maps.value
  const where =
    others.length > 0 ? t('lab.build.mapCount', { count: maps.value.length }) : map?.name
  if (ablated.value !== null)
    return t('lab.build.ablationTitle', { planner: ablated.value, where: where ?? '' })
  const names = entries.value.map(labelOf)
  const what =
    names.length <= 2 ? names.join(' – ') : t('lab.build.plannerCount', { count: names.length })
  return t('lab.build.autoTitle', { what, where: where ?? '' })
}

/** A planner and all the values with which it runs. */
export function labelOfPlanner(
  planner: string,
  preset: string | null,
  params: DraftEntry['params'],
): string {
  const known = plannerEntry(planner)
  const set = known?.presets.find((each) => each.name === preset)
  const values = Object.entries(params).map(([key, value]) => `${key} = ${value}`)
  const rest = [...(set ? [presetName(set)] : []), ...values]
  return rest.length > 0 ? `${nameOf(planner)}: ${rest.join(', ')}` : nameOf(planner)
}
