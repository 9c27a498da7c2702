import { numbers, t } from '../i18n'
import { goalName } from '../model/goals'
import {
  byHand,
  type Panel,
  panels,
  plannerEntry,
  referenceOf,
  scenario,
  shownOf,
  slotColour,
} from '../state'
import { panelGap } from '../words/gap_words'
import { bestOf, GAP_ROW, METRIC_ROWS, type MetricRow } from '../words/metric_rows'
import { objectiveWord } from '../words/objective_words'
import { panelTitle } from '../words/planner_words'

/** Every panel's numbers side by side; the better one of a row stands out. */
export function MetricsTable() {
  const all = [...panels.value, ...byHand.value]
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="table-scroll" tabIndex={0} aria-label={t('metrics.title')}>
      <table class="metrics">
        <caption class="visually-hidden">{t('metrics.caption')}</caption>
        <thead>
          <tr>
            <td />
            {all.map((panel) => (
              <th key={panel.id} scope="col" style={{ '--panel-colour': slotColour(panel.slot) }}>
                <span class="panel-dot" aria-hidden="true" />
                {panelTitle(panel.id) || panel.setup.planner}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <Row row={GAP_ROW} all={all} />
          <TextRow id="comparedWith" all={all} text={comparedWith} />
          <TextRow id="order" all={all} text={orderOf} optional />
          {METRIC_ROWS.map((row) => (
            <Row key={row.id} row={row} all={all} />
          ))}
          <TextRow id="digest" all={all} text={digestOf} />
        </tbody>
      </table>
    </section>
  )
}

interface Words {
  text: string
  /** A second line. */
  note?: string
  /** Why there is only a dash. */
  why?: string
}

interface TextRowProps {
  id: 'comparedWith' | 'order' | 'digest'
  all: Panel[]
  text: (panel: Panel) => Words | null
  /** Left out while no panel has it. */
  optional?: boolean
}

function TextRow({ id, all, text, optional }: TextRowProps) {
  const words = all.map(text)
  if (optional && words.every((each) => each === null)) return null
  return (
    <tr>
      <th scope="row" title={t(`metrics.hints.${id}`)}>
        {t(`metrics.${id}`)}
      </th>
      {words.map((each, index) => (
        <td
          key={all[index]?.id}
          class={id}
          title={each?.why}
          data-testid={`metric-${id}-${index + 1}`}
        >
          <span>{each?.text ?? '–'}</span>
          {each?.why && <span class="visually-hidden"> {each.why}</span>}
          {each?.note && <span class="cell-note">{each.note}</span>}
        </td>
      ))}
    </tr>
  )
}

/** What a panel's gap is taken from. */
function comparedWith(panel: Panel): Words | null {
  const reference = referenceOf(panel)
  const { objective } = shownOf(panel)
  if (!reference || !objective) return null
  switch (reference.kind) {
    case 'no-path':
      return { text: '–', why: t('race.unreachable') }
    case 'unknown':
      return { text: '–', why: t('gap.unknownWhy') }
    default: {
      const value = numbers.value.length.format(reference.value)
      const note = reference.kind === 'unproven' ? { note: t('gap.notProven') } : {}
      return { text: `${t(`objective.${objectiveWord(objective)}`)} ${value}`, ...note }
    }
  }
}

function orderOf(panel: Panel): Words | null {
  const order = shownOf(panel).summary?.tour?.order
  const spec = scenario.value?.spec
  return order && spec ? { text: order.map((goal) => goalName(spec, goal)).join(' → ') } : null
}

/** Before the first step every run has the digest of nothing. */
function digestOf(panel: Panel): Words | null {
  const { summary } = shownOf(panel)
  const begun = summary && summary.effort.ant_moves + summary.effort.cell_expansions > 0
  return begun ? { text: summary.digest } : null
}

function Row({ row, all }: { row: MetricRow; all: Panel[] }) {
  const values = all.map((panel) => {
    const { summary } = shownOf(panel)
    const family = plannerEntry(panel.setup.planner)?.family
    if (row.families && !(family && row.families.includes(family))) return null
    return summary && row.value(summary, panelGap(panel))
  })
  if (row.optional && values.every((value) => value === null)) return null
  const best = bestOf(values, row.better)
  return (
    <tr class={row.id === 'gap' ? 'leading' : undefined}>
      <th scope="row" title={t(`metrics.hints.${row.id}`)}>
        {t(`metrics.${row.id}`)}
      </th>
      {values.map((value, index) => (
        <td
          key={all[index]?.id}
          class={best.has(index) ? 'better' : undefined}
          data-testid={`metric-${row.id}-${index + 1}`}
          data-value={value ?? ''}
        >
          {value === null ? '–' : row.format(value)}
        </td>
      ))}
    </tr>
  )
}
