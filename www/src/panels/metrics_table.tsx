import { t } from '../i18n'
import { optimum, type Panel, panels, plannerEntry, slotColour } from '../state'
import { gapOf } from './gap'
import { bestOf, METRIC_ROWS, type MetricRow } from './metric_rows'
import { panelTitle } from './planner_text'

/** Every panel's numbers side by side; the better one of a row stands out. */
export function MetricsTable() {
  const all = panels.value
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
                {panelTitle(panel.id)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {METRIC_ROWS.map((row) => (
            <Row key={row.id} row={row} all={all} />
          ))}
          <tr>
            <th scope="row" title={t('metrics.hints.digest')}>
              {t('metrics.digest')}
            </th>
            {all.map((panel, index) => (
              <td key={panel.id} class="digest" data-testid={`metric-digest-${index + 1}`}>
                <span>{digestOf(panel)}</span>
              </td>
            ))}
          </tr>
        </tbody>
      </table>
    </section>
  )
}

/** Before the first step every run has the digest of nothing. */
function digestOf(panel: Panel): string {
  const { summary } = panel.live.value
  const begun = summary && summary.effort.ant_moves + summary.effort.cell_expansions > 0
  return begun ? summary.digest : '–'
}

function Row({ row, all }: { row: MetricRow; all: Panel[] }) {
  const values = all.map((panel) => {
    const { summary } = panel.live.value
    if (row.family && row.family !== plannerEntry(panel.setup.planner)?.family) return null
    const gap = gapOf(summary?.metrics?.length, optimum.value)
    return summary && row.value(summary, gap)
  })
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
