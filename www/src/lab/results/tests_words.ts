/** Tests of pairs read as comparisons, and what they allow to say. */
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { inTurn, listed } from '../../i18n/lists'
import type { EntryAnalysis, MapAnalysis } from '../../model/analysis'
import { chance, labelOf } from '../words/numbers'
import { differ, effectOf, type Kind, type PairTest, pairTest } from './pair_tests'

/** Fewest runs that are tested (the engine's MIN_RUNS). */
const FEWEST = 20

/** Conclusions, clearest first, and the pairs that allow none. */
export function sentences(map: MapAnalysis, kind: Kind): string[] {
  const all = map.pairs.flatMap(({ first, second }) => {
    const [a, b] = [map.entries[first], map.entries[second]]
    const pair = pairTest(map, first, second, kind)
    return a && b && pair ? [{ a, b, pair }] : []
  })
  const certain = all.filter(({ pair }) => differ(pair))
  const open = all.filter(({ pair }) => pair.p !== null && !differ(pair))
  const unpaired = all.filter(
    ({ a, b, pair }) => pair.p === null && !pair.paired && enough(a) && enough(b),
  )
  const few = map.entries.filter((entry) => entry.runs > 0 && !enough(entry))
  const wrong = map.entries.filter(({ impossible }) => impossible > 0)
  const untested =
    wrong.length > 0 ? [t('lab.matrix.untested', { entries: wrong.map(labelOf).join(', ') })] : []
  if (all.length === 0) return untested.length > 0 ? untested : [t('lab.results.onePlanner')]
  return [
    ...untested,
    ...certain.sort((x, y) => (x.pair.p ?? 1) - (y.pair.p ?? 1)).map(ahead),
    ...(open.length > 0 ? [t('lab.results.noDifference', { pairs: listOf(open) })] : []),
    ...(kind === 'wilcoxon' && unpaired.length > 0
      ? [t('lab.results.unpaired', { pairs: listOf(unpaired) })]
      : []),
    ...(few.length > 0
      ? [t('lab.results.tooFew', { least: FEWEST, entries: listed(few.map(labelOf)) })]
      : []),
  ]
}

const enough = ({ runs }: EntryAnalysis) => runs >= FEWEST

interface Both {
  a: EntryAnalysis
  b: EntryAnalysis
  pair: PairTest
}

function ahead({ a, b, pair }: Both): string {
  const [winner, loser, better] = pair.better >= 0.5 ? [a, b, pair.better] : [b, a, 1 - pair.better]
  const p = pair.p ?? 1
  return t('lab.results.ahead', {
    winner: labelOf(winner),
    loser: labelOf(loser),
    share: numbers.value.share.format(better),
    effect: t(`lab.results.effects.${effectOf(better)}`),
    p: p < 0.001 ? `p ${chance(p)}` : `p = ${chance(p)}`,
  })
}

const listOf = (all: Both[]) => inTurn(all.map(({ a, b }) => `${labelOf(a)} – ${labelOf(b)}`))
