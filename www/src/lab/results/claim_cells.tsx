/** What tables of claims have in common: the verdict, on how many maps, and effects. */
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Analysis, OverMaps } from '../../model/analysis'
import { dash } from '../words/numbers'

export function Chip({ verdict }: { verdict: OverMaps['verdict'] }) {
  return <span class={`chip verdict-${verdict}`}>{t(`lab.claims.verdicts.${verdict}`)}</span>
}

/** On how many maps it is better. */
export const partOfMaps = ({ better, maps }: OverMaps) =>
  maps === 0 ? t('lab.claims.none') : t('lab.claims.onMaps', { part: better, whole: maps })

/** What an effect is of. */
type Of = Pick<OverMaps, 'is_share' | 'direction'>

/** How large an effect is: a part of the baseline's value, of shares a difference in points. What is infinite has no number. */
export function size(of: Of, effect: number | null): string {
  if (!of.is_share) return dash(effect, numbers.value.percent.format)
  return dash(effect, (points) =>
    t('lab.claims.points', { shown: numbers.value.length.format(100 * points) }),
  )
}

/** The change that an effect is: where less is claimed, one as claimed is below 0. */
export function change(of: Of, effect: number | null): string {
  return size(of, effect === null ? null : signed(of, effect))
}

const signed = ({ direction }: Of, effect: number) => (direction === 'less' ? -effect : effect)

/** An end of the interval of an effect that no number has is infinite. */
export function within(of: Of, low: number | null, high: number | null): string {
  const ends = [low ?? -Infinity, high ?? Infinity].map((end) => signed(of, end))
  const [from, to] = ends.toSorted((a, b) => a - b).map((end) => endOf(of, end))
  return t('lab.claims.interval', { low: from, high: to })
}

function endOf(of: Of, end: number): string {
  if (Number.isFinite(end)) return size(of, end)
  return end < 0 ? '−∞' : '∞'
}

/** Why over its maps nothing can be told. */
export function whyNotOver({ claim }: OverMaps, { verdicts }: Analysis): string {
  const lines = verdicts.filter((line) => line.claim === claim)
  const lackRuns = lines.every(({ why }) => why === 'too few runs to compare')
  return t(lackRuns ? 'lab.claims.fewRuns' : 'lab.claims.fewMaps')
}
