/** Makes the document of a comparison from the draft. */
import type { Entry, Question } from '@pkg/formicarium'
import { lateTools } from '../../engine/late_tools'
import { t } from '../../i18n/lab'
import { type ComparisonDocument, type MapOfQuestion, textOf } from '../../model/comparison'
import type { DraftEntry } from '../../model/draft'
import { formats } from '../../model/facts'
import type { ParamValues } from '../../model/messages'
import { noteText } from '../../model/names'
import { plannerEntry } from '../../state'
import { uniqueId } from '../store/names'
import { budget, entries, maps, note, seeds, untilBudget } from './draft'
import { idsOf, labelOf, titleOf } from './labels'

export async function compose(): Promise<string> {
  const drawn = maps.peek()
  const texts = await Promise.all(
    drawn.map(({ scenario }) => lateTools.exportMap(scenario, 'scenario')),
  )
  const document: ComparisonDocument = {
    format: formats.comparison,
    question: questionOf(),
    maps: texts.map((text, at) => ({
      ...(JSON.parse(text) as MapOfQuestion),
      name: drawn[at]?.name ?? '',
    })),
  }
  return textOf(document)
}

/** The ids of the maps in the document. */
export function instanceIds(): string[] {
  const ids: string[] = []
  for (const { name } of maps.peek()) ids.push(uniqueId(name || t('lab.build.map'), ids))
  return ids
}

function questionOf(): Question {
  const ids = instanceIds()
  const instances = maps.peek().map(({ name, scenario }, at) => {
    const { width, height } = scenario.spec
    const id = ids[at] ?? ''
    return { id, map: `${id}.json`, note: `${name}, ${width} × ${height}` }
  })
  const all = entries.peek()
  const entryIds = idsOf(all)
  const limit = budget.peek()
  return {
    format: formats.question,
    title: titleOf(),
    asks: noteText(note.peek()) || t('lab.build.asks'),
    seeds: seeds.peek(),
    ...(limit && { budget: limit }),
    instances,
    entries: all.map((entry, at) => entryOf(entry, entryIds[at] ?? '')),
  }
}

function entryOf(entry: DraftEntry, id: string): Entry {
  const { planner, preset, params } = entry
  const set = untilBudget.peek() && budget.peek() ? { ...params, ...endless(planner) } : params
  return {
    id,
    label: labelOf(entry),
    role: entry.ablation?.kind === 'full' ? 'improved' : 'other',
    planner,
    preset,
    set,
  }
}

/** The values with which a planner does not end by itself. */
function endless(planner: string): ParamValues {
  const values: ParamValues = {}
  for (const { key, kind } of plannerEntry(planner)?.params ?? []) {
    if (key === 'iterations' && 'max' in kind) values[key] = kind.max
    if (key === 'stagnation') values[key] = 0
  }
  return values
}
