/**
 * The open comparison and its analysis as the page shows them: lengths in the reader's unit, and known texts, such as those of the
 * papers' questions, in the reader's language. Files are made from the comparison itself, so what people wrote in it stays as it is there.
 */
import type { Claim, Entry, Instance, Question } from '@pkg/formicarium'
import { computed } from '@preact/signals'
import { translated } from '../../i18n'
import type {
  Analysis,
  EntryAnalysis,
  MapAnalysis,
  OverMaps,
  UnfitMap,
  VerdictLine,
} from '../../model/analysis'
import { madeMapName } from '../../words/made_maps'
import { inMetres, metresOfMaps } from './metres'
import { analysis, type OpenComparison, openComparison } from './signals'

type ShownComparison = Pick<OpenComparison, 'id' | 'title' | 'question' | 'maps'>

export const shownComparison = computed(
  () => openComparison.value && ofComparison(openComparison.value),
)
export const shownAnalysis = computed(() => {
  if (!analysis.value) return null
  const metres = metresOfMaps.value
  return ofAnalysis(metres ? inMetres(analysis.value, metres) : analysis.value)
})

/** Null and empty text stay as they are. */
const told = <T extends string | null | undefined>(text: T) =>
  (text ? translated(text) : text) as T | string

/** Of a map: one that a generator has made is told by kind, size and seed. */
const toldName = (name: string) => madeMapName(name) ?? told(name)

function ofComparison({ id, title, question, maps }: OpenComparison): ShownComparison {
  return {
    id,
    title: told(title),
    question: ofQuestion(question),
    maps: maps.map((map) => ({ ...map, name: toldName(map.name) })),
  }
}

function ofQuestion(question: Question): Question {
  const { title, paper, asks, instances, entries, claims = [] } = question
  return {
    ...question,
    title: told(title),
    paper: told(paper),
    asks: told(asks),
    instances: instances.map((one): Instance => ({ ...one, note: told(one.note) })),
    entries: entries.map(
      (one): Entry => ({ ...one, label: told(one.label), missing: told(one.missing) }),
    ),
    claims: claims.map((one): Claim => ({ ...one, says: told(one.says), note: told(one.note) })),
  }
}

function ofAnalysis(of: Analysis): Analysis {
  const verdicts = of.verdicts.map((line): VerdictLine => ({ ...line, says: told(line.says) }))
  const over_maps = of.over_maps.map((over): OverMaps => ({ ...over, says: told(over.says) }))
  const unfit = of.unfit.map((map): UnfitMap => ({ ...map, says: told(map.says) }))
  return { ...of, instances: of.instances.map(ofMap), verdicts, over_maps, unfit }
}

function ofMap(map: MapAnalysis): MapAnalysis {
  const entries = map.entries.map((one): EntryAnalysis => ({ ...one, label: told(one.label) }))
  return { ...map, name: toldName(map.name), note: told(map.note), entries }
}
