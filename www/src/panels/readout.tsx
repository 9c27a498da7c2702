import type { RunSummary } from '@pkg/formicarium'
import { numbers, t } from '../i18n'
import { optimum, type Panel, plannerEntry } from '../state'
import { gapOf } from './gap'
import { panelTitle } from './planner_text'

/** The panel's result at a glance: how far from the proven optimum, how long, how far it has come. */
export function Readout({ panel, place }: { panel: Panel; place: number }) {
  const { summary } = panel.live.value
  const length = summary?.metrics?.length ?? null
  const gap = gapOf(length, optimum.value)
  const tone = gap === null ? 'none' : gap === 0 ? 'best' : 'above'
  return (
    <div class="readout">
      <div class={`gap ${tone}`} data-testid={`gap-${place}`} data-gap={gap ?? ''}>
        {gap !== null && <strong class="gap-value">{numbers.value.percent.format(gap)}</strong>}
        <span class="gap-words">{gapWords(length, gap)}</span>
      </div>
      <dl class="readout-facts">
        <Fact label={t('metrics.length')} testId={`readout-length-${place}`}>
          {length === null ? '–' : numbers.value.length.format(length)}
        </Fact>
        <ProgressFacts panel={panel} place={place} />
      </dl>
      <ProgressBar panel={panel} />
    </div>
  )
}

/** Colonies count iterations and arrived ants, exact planners the cells they have looked at. */
function ProgressFacts({ panel, place }: { panel: Panel; place: number }) {
  const { summary } = panel.live.value
  const { whole } = numbers.value
  if (plannerEntry(panel.setup.planner)?.family === 'exact') {
    return (
      <Fact label={t('metrics.expandedShort')} testId={`expansions-${place}`}>
        {whole.format(summary?.effort.cell_expansions ?? 0)}
      </Fact>
    )
  }
  const budget = summary?.iteration_budget
  const iteration = whole.format(summary?.iteration ?? 0)
  return (
    <>
      <Fact label={t('metrics.iteration')} testId={`iteration-${place}`}>
        {budget ? `${iteration} / ${whole.format(budget)}` : iteration}
      </Fact>
      <Fact label={t('metrics.arrived')} testId={`arrived-${place}`}>
        {summary && summary.iteration > 0 ? `${summary.arrived} / ${summary.ants}` : '–'}
      </Fact>
    </>
  )
}

function Fact(props: { label: string; testId: string; children: string }) {
  return (
    <div class="fact">
      <dt>{props.label}</dt>
      <dd data-testid={props.testId}>{props.children}</dd>
    </div>
  )
}

function ProgressBar({ panel }: { panel: Panel }) {
  const share = progress(panel.live.value.summary)
  return (
    <div
      class="progress-bar"
      role="progressbar"
      aria-label={t('panels.progress', { planner: panelTitle(panel.id) })}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(100 * share)}
    >
      <span style={{ transform: `scaleX(${share})` }} />
    </div>
  )
}

/** The share of the iterations a colony may take. An exact planner cannot know how far it is until it has its proof. */
function progress(summary: RunSummary | null): number {
  if (!summary) return 0
  if (!summary.iteration_budget) return summary.status === 'running' ? 0 : 1
  return Math.min(1, summary.iteration / summary.iteration_budget)
}

function gapWords(length: number | null, gap: number | null): string {
  if (optimum.value === Number.POSITIVE_INFINITY) return t('gap.noPathExists')
  if (length === null) return t('gap.noPathYet')
  if (gap === null) return t('gap.proving')
  return gap === 0 ? t('gap.shortest') : t('gap.above')
}
