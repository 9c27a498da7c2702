/** One field of the matrix: the chosen number large, the others below it. */
import { t } from '../../i18n/lab'
import type {
  Analysis,
  MapAnalysis,
  Matrix,
  MatrixCell,
  Measure,
  Overall,
} from '../../model/analysis'
import { gapShown } from '../../words/gap_words'
import { amount, dash, share, significant } from '../words/numbers'

export const SHOWS = ['median', 'gap', 'success', 'rank'] as const
export type Shows = (typeof SHOWS)[number]

/** The gaps at which the shade changes, smallest first: those of the engine's targets. */
export function thresholds({ instances }: Analysis): number[] {
  const known = instances.find(({ target_gaps }) => target_gaps.length > 0)
  return [...(known?.target_gaps ?? [])].reverse()
}

/** How many of them its gap is above; null where there is no gap, and where it says nothing. */
export function heatOf({ gap, impossible }: MatrixCell, { target_gaps }: MapAnalysis) {
  if (gap === null || impossible > 0) return null
  return target_gaps.filter((most) => gap > most).length
}

interface FieldProps {
  cell: MatrixCell
  measure: Measure
  large: Shows
  heat: number | null
  isBest: boolean
}

export function MatrixField({ cell, measure, large, heat, isBest }: FieldProps) {
  const { runs, impossible } = cell
  if (runs === 0) return <td class="matrix-none">{t('lab.matrix.notRun')}</td>
  const texts = {
    median: cell.median === null ? t('lab.matrix.noPath') : amount(measure)(cell.median),
    gap: dash(cell.gap, gapShown),
    success: dash(cell.success, share),
    rank: dash(cell.rank, significant),
  }
  const others = SHOWS.filter((one) => one !== large && cell[one] !== null)
  const failed = cell.success !== null && cell.success < 1
  return (
    <td
      class={classOf({ heat, impossible, failed: failed && large === 'success' })}
      style={heat === null ? undefined : { '--heat': heat }}
      data-heat={heat ?? 'none'}
    >
      <Large text={texts[large]} isBest={isBest} />
      {impossible > 0 && (
        <span class="cell-small matrix-impossible">
          {t('lab.matrix.impossible', { part: impossible, whole: runs })}
        </span>
      )}
      {others.map((one) => (
        <span key={one} class="cell-small" data-part={one}>
          {t(`lab.matrix.small.${one}`, { value: texts[one] })}
        </span>
      ))}
    </td>
  )
}

function classOf(is: { heat: number | null; impossible: number; failed: boolean }): string {
  if (is.impossible > 0) return 'matrix-field impossible'
  if (is.failed) return 'matrix-field failed'
  return is.heat === null ? 'matrix-field' : 'matrix-field heated'
}

function Large({ text, isBest }: { text: string; isBest: boolean }) {
  return <span class="matrix-large">{isBest ? <strong>{text}</strong> : text}</span>
}

interface OverallProps {
  all: Overall
  of: Matrix
  large: Shows
}

/** Lengths of different maps have no mean: where they are large, the mean rank is so here. */
export function OverallField({ all, of, large }: OverallProps) {
  const ranks = of.overall.flatMap(({ mean_rank }) => mean_rank ?? [])
  const best = ranks.length > 1 && all.mean_rank === Math.min(...ranks)
  const parts = {
    rank: all.mean_rank === null ? null : significant(all.mean_rank),
    gap: all.mean_gap === null ? null : gapShown(all.mean_gap),
    success: all.success === null ? null : share(all.success),
  }
  const shown = large === 'median' ? 'rank' : large
  const names = { rank: 'meanRank', gap: 'meanGap', success: 'success' } as const
  return (
    <td>
      <Large text={parts[shown] ?? '–'} isBest={best} />
      {(['rank', 'gap', 'success'] as const).map((part) =>
        part === shown || parts[part] === null ? null : (
          <span key={part} class="cell-small">
            {t(`lab.matrix.small.${names[part]}`, { value: parts[part] })}
          </span>
        ),
      )}
      {all.unranked && <span class="cell-small">{t(`lab.matrix.unranked.${all.unranked}`)}</span>}
    </td>
  )
}
