/** What tables of claims have in common: the verdict, on how many maps, and effects. */
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { OverMaps } from '../../model/analysis'
import { dash } from '../words/numbers'

export function Chip({ verdict }: { verdict: OverMaps['verdict'] }) {
  return <span class={`chip verdict-${verdict}`}>{t(`lab.claims.verdicts.${verdict}`)}</span>
}

/** On how many maps it is better. */
export const partOfMaps = ({ better, maps }: OverMaps) =>
  maps === 0 ? t('lab.claims.none') : t('lab.claims.onMaps', { part: better, whole: maps })

/** A part of the baseline's value; of shares a difference in points. What is infinite has no number. */
export function effect(isShare: boolean, of: number | null): string {
  if (!isShare) return dash(of, numbers.value.percent.format)
  return dash(of, (points) =>
    t('lab.claims.points', { shown: numbers.value.length.format(100 * points) }),
  )
}

/** An end that no number has is infinite. */
export function within(isShare: boolean, low: number | null, high: number | null): string {
  const end = (of: number | null, infinite: string) =>
    of === null ? infinite : effect(isShare, of)
  return t('lab.claims.interval', { low: end(low, '−∞'), high: end(high, '∞') })
}
