/** What the comparison says of every panel: one measure after the other, each with its words for all panels. */
import { t } from '../i18n'
import { goalName } from '../model/goals'
import { type Panel, plannerEntry, referenceOf, scenario, shownOf } from '../state'
import { panelGap } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import {
  bestOf,
  EFFORT_ROWS,
  GAP_ROW,
  type MetricId,
  type MetricRow,
  PATH_ROWS,
} from '../words/metric_rows'
import { objectiveWord } from '../words/objective_words'
import { curveMeasures } from './curve_measures'
import { proofMeasure } from './proof_measure'

export interface MeasureCell {
  text: string
  /** A second line. */
  note?: string
  /** Whether that line only says more: as a rule it is a warning. */
  quiet?: boolean
  /** Why there is only a dash. */
  why?: string
  /** The number behind the text, lengths in cells; null where it has none. */
  value?: number | null
  better?: boolean
}

export interface Measure {
  id:
    | MetricId
    | 'comparedWith'
    | 'order'
    | 'curveLength'
    | 'curveCurvature'
    | 'curveBound'
    | 'proof'
    | 'digest'
  /** Words rather than numbers: they want more room. */
  wordy: boolean
  /** Whether it is a length (see `MetricRow`). */
  isLength?: true | undefined
  /** One of each panel, in their order. */
  cells: MeasureCell[]
}

/** Those that some panel has; the gap comes first. */
export function measuresOf(all: Panel[]): Measure[] {
  const driving = tellsDriving(all)
  const found = [
    numeric(GAP_ROW, all),
    wordy('comparedWith', all.map(comparedWith)),
    optional(wordy('order', all.map(orderOf))),
    ...PATH_ROWS.filter((row) => !row.ofDriving || driving).map((row) =>
      row.optional ? optional(numeric(row, all)) : numeric(row, all),
    ),
    ...curveMeasures(all),
    ...EFFORT_ROWS.map((row) => numeric(row, all)),
    proofMeasure(all),
    wordy('digest', all.map(digestOf)),
  ]
  return found.filter((measure) => measure !== null)
}

/** Whether the scenario asks how paths are to drive, and every panel with a path can say it. */
function tellsDriving(all: Panel[]): boolean {
  const spec = scenario.value?.spec
  if (!spec?.robot && !spec?.vehicle.energy && !spec?.vehicle.smoothing) return false
  return all.every((panel) => {
    const metrics = shownOf(panel).summary?.metrics
    return !metrics || metrics.driving
  })
}

const NOTHING: MeasureCell = { text: '–' }

function wordy(id: Measure['id'], cells: (MeasureCell | null)[]): Measure {
  return { id, wordy: true, cells: cells.map((cell) => cell ?? NOTHING) }
}

/** Null where no panel has it. */
const optional = (measure: Measure) =>
  measure.cells.every((cell) => cell === NOTHING || cell.value === null) ? null : measure

function numeric(row: MetricRow, all: Panel[]): Measure {
  const values = all.map((panel) => {
    const { summary } = shownOf(panel)
    const family = plannerEntry(panel.setup.planner)?.family
    if (row.families && !(family && row.families.includes(family))) return null
    return summary && row.value(summary, panelGap(panel))
  })
  const best = bestOf(values, row.better)
  const cells = values.map((value, index) => ({
    text: value === null ? '–' : row.format(value),
    value,
    better: best.has(index),
  }))
  return { id: row.id, wordy: false, isLength: row.isLength, cells }
}

/** What a panel's gap is taken from. */
function comparedWith(panel: Panel): MeasureCell | null {
  const reference = referenceOf(panel)
  const { objective } = shownOf(panel)
  if (!reference || !objective) return null
  switch (reference.kind) {
    case 'no-path':
      return { text: '–', why: t('race.unreachable') }
    case 'unknown':
      return { text: '–', why: t('gap.unknownWhy') }
    default: {
      const value = lengthShown(reference.value)
      const note = reference.kind === 'unproven' ? { note: t('gap.notProven') } : {}
      return { text: `${t(`objective.${objectiveWord(objective)}`)} ${value}`, ...note }
    }
  }
}

function orderOf(panel: Panel): MeasureCell | null {
  const order = shownOf(panel).summary?.tour?.order
  const spec = scenario.value?.spec
  return order && spec ? { text: order.map((goal) => goalName(spec, goal)).join(' → ') } : null
}

/** Before the first step every run has the digest of nothing. */
function digestOf(panel: Panel): MeasureCell | null {
  const { summary } = shownOf(panel)
  const begun = summary && summary.effort.ant_moves + summary.effort.cell_expansions > 0
  return begun ? { text: summary.digest } : null
}
