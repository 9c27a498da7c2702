/** Labels of entries and the title, unless the reader has written others. */
import { t } from '../../i18n/lab'
import type { DraftEntry } from '../../model/draft'
import { plannerEntry } from '../../state'
import { plannerName, presetName } from '../../words/planner_words'
import { uniqueId } from '../store/names'
import { ablated, entries, maps, title } from './draft'

/** Its planner, and its preset or values in brackets. */
export function labelOf(entry: DraftEntry): string {
  if (entry.label !== null) return entry.label
  const plain = usualLabel(entry)
  const namesakes = entries.value.filter(
    (other) => other.label === null && usualLabel(other) === plain,
  )
  const place = namesakes.findIndex(({ key }) => key === entry.key)
  return place > 0 ? `${plain} (${place + 1})` : plain
}

type Named = Pick<DraftEntry, 'planner' | 'preset' | 'params'>

export function usualLabel({ planner, preset, params }: Named): string {
  const known = plannerEntry(planner)
  const name = known ? plannerName(known) : planner
  const set = known?.presets.find((each) => each.name === preset)
  if (set) return `${name} (${presetName(set)})`
  const changed = Object.entries(params).map(([key, value]) => `${key} ${value}`)
  return changed.length > 0 && changed.length <= 2 ? `${name} (${changed.join(', ')})` : name
}

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

/** A planner and the values with which it runs. */
export function labelOfPlanner(
  planner: string,
  preset: string | null,
  params: DraftEntry['params'],
): string {
  const known = plannerEntry(planner)
  const set = known?.presets.find((each) => each.name === preset)
  const values = Object.entries(params).map(([key, value]) => `${key} = ${value}`)
  const name = known ? plannerName(known) : planner
  const rest = [...(set ? [presetName(set)] : []), ...values]
  return rest.length > 0 ? `${name}: ${rest.join(', ')}` : name
}
