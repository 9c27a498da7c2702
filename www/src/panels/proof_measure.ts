/** What the comparison says of what planners have proven. */
import type { Certificate, RunSummary } from '@pkg/formicarium'
import { language, numbers } from '../i18n'
import { t } from '../i18n/column'
import { relativeGap } from '../model/gap'
import { type Panel, shownOf } from '../state'
import { certificateOf, proves } from '../state/certificates'
import { lengthShown } from '../words/lengths'
import { isWeighted } from '../words/objective_words'
import type { Measure, MeasureCell } from './measures'

/** None where no planner proves anything. Its place is there before anything is proven. */
export function proofMeasure(all: Panel[]): Measure | null {
  return all.some(proves) ? { id: 'proof', wordy: true, cells: all.map(cellOf) } : null
}

function cellOf(panel: Panel): MeasureCell {
  const { summary } = shownOf(panel)
  const certificate = certificateOf(panel)
  if (!summary || !certificate) return { text: '–' }
  const { lower_bound: bound, expansions } = certificate
  const effort = t('metrics.proofs.expansions', { number: numbers.value.whole.format(expansions) })
  return {
    text: textOf(certificate, summary),
    note: intervalOf(certificate, summary) + effort,
    quiet: true,
    value: bound,
  }
}

function textOf({ lower_bound: bound, complete }: Certificate, summary: RunSummary): string {
  const isLength = summary.objective.endsWith('length') && !isWeighted()
  if (complete) return t(isLength ? 'metrics.proofs.shortest' : 'metrics.proofs.least')
  if (summary.value === null) return t('metrics.proofs.above', { bound: lengthShown(bound) })
  return t('metrics.proofs.within', { gap: atMost(relativeGap(summary.value, bound)) })
}

/** The bound and the result, where something lies between them. */
function intervalOf({ lower_bound: bound, complete }: Certificate, { value }: RunSummary): string {
  if (complete || value === null) return ''
  return t('metrics.proofs.interval', { bound: lengthShown(bound), value: lengthShown(value) })
}

/** A gap is never told smaller than it is. */
function atMost(gap: number): string {
  const percent = new Intl.NumberFormat(language.value, {
    style: 'percent',
    maximumFractionDigits: 2,
  })
  return percent.format(Math.ceil(gap * 1e4) / 1e4)
}
