/** A test of a pair, read from either side. */

import type { MapAnalysis } from '../../model/analysis'
import { LEVEL } from '../figures/rank_groups'

export type Kind = 'wilcoxon' | 'mann-whitney'

export interface PairTest {
  /** How likely a run of the first beats one of the second; ties half. */
  better: number
  /** Adjusted by Holm; null where there is no test. */
  p: number | null
  paired: boolean
}

/** One pair, seen from the first of the two. Null of an entry with itself. */
export function pairTest(
  { pairs }: Pick<MapAnalysis, 'pairs'>,
  first: number,
  second: number,
  kind: Kind,
): PairTest | null {
  const pair = pairs.find(
    (p) => (p.first === first && p.second === second) || (p.first === second && p.second === first),
  )
  if (!pair) return null
  const better = pair.first === first ? pair.a12 : 1 - pair.a12
  const p = kind === 'wilcoxon' ? pair.wilcoxon_holm : pair.mann_whitney_holm
  return { better, p, paired: pair.paired }
}

/** Whether chance is ruled out. */
export const differ = ({ p }: PairTest) => p !== null && p < LEVEL

export type EffectSize = 'negligible' | 'small' | 'medium' | 'large'

/** The effect size to show: without significance none is claimed, however far A is from ½. */
export const shownEffect = (pair: PairTest): EffectSize | 'unknown' =>
  differ(pair) ? effectOf(pair.better) : 'unknown'

/** Words of Vargha and Delaney (2000) for how far A is from ½. */
export function effectOf(better: number): EffectSize {
  const away = Math.abs(better - 0.5)
  if (away < 0.06) return 'negligible'
  if (away < 0.14) return 'small'
  return away < 0.21 ? 'medium' : 'large'
}
