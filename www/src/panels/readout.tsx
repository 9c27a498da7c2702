import type { Reference, RunSummary } from '@pkg/formicarium'
import { numbers, t } from '../i18n'
import { type Panel, referenceOf, referenceRefusal, shownOf } from '../state'
import { gapShown, panelGap } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import { OTHER_VALUES, objectiveWord } from '../words/objective_words'
import { isSearch, panelTitle } from '../words/planner_words'

/** The panel's result at a glance: how far from the best there is, how long, how far it has come. */
export function Readout({ panel, place }: { panel: Panel; place: number }) {
  const { summary } = shownOf(panel)
  const length = summary?.metrics?.length ?? null
  const gap = panelGap(panel)
  const reference = referenceOf(panel)
  const best = gap === 0 && reference?.kind === 'proven'
  const tone = gap === null ? 'none' : best ? 'best' : 'above'
  const words = gapWords(panel, gap)
  return (
    <div class="readout">
      <div class={`gap ${tone}`} data-testid={`gap-${place}`} data-gap={gap ?? ''} title={words}>
        {gap !== null && <strong class="gap-value">{gapShown(gap)}</strong>}
        <span class="gap-words">{words}</span>
      </div>
      <dl class="readout-facts">
        <Fact label={t('metrics.length')} testId={`readout-length-${place}`}>
          {length === null ? '–' : lengthShown(length)}
        </Fact>
        <ObjectiveFact summary={summary} place={place} />
        <ProgressFacts panel={panel} place={place} />
      </dl>
      <ProgressBar panel={panel} />
    </div>
  )
}

/** The value that the gap is about, where it is not the length. */
function ObjectiveFact({ summary, place }: { summary: RunSummary | null; place: number }) {
  if (!summary) return null
  const { value, objective } = summary
  const label = OTHER_VALUES[objectiveWord(objective)]
  if (!label) return null
  return (
    <Fact label={t(label)} testId={`readout-value-${place}`} leading>
      {value === null ? '–' : lengthShown(value)}
    </Fact>
  )
}

/** Colonies count iterations and arrived ants, searches the cells they have looked at. */
function ProgressFacts({ panel, place }: { panel: Panel; place: number }) {
  const { summary } = shownOf(panel)
  const { whole } = numbers.value
  if (isSearch(panel.setup.planner)) {
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

function Fact(props: { label: string; testId: string; children: string; leading?: boolean }) {
  return (
    <div class={props.leading ? 'fact leading' : 'fact'} title={props.label}>
      <dt>{props.label}</dt>
      <dd data-testid={props.testId}>{props.children}</dd>
    </div>
  )
}

function ProgressBar({ panel }: { panel: Panel }) {
  const share = progress(shownOf(panel).summary)
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

/** The share of the iterations a colony may take. A search cannot know how far it is until it has its path. */
function progress(summary: RunSummary | null): number {
  if (!summary) return 0
  if (!summary.iteration_budget) return summary.status === 'running' ? 0 : 1
  return Math.min(1, summary.iteration / summary.iteration_budget)
}

function gapWords(panel: Panel, gap: number | null): string {
  const reference = referenceOf(panel)
  const { summary, objective } = shownOf(panel)
  if (reference?.kind === 'no-path') return t('gap.noPathExists')
  if (summary && !summary.metrics && summary.status !== 'running') return t('gap.noPathFound')
  if (!summary?.metrics || !objective) return t('gap.noPathYet')
  if (reference === null) return t(referenceRefusal.value ? 'gap.unknown' : 'gap.proving')
  if (gap === null) return t('gap.unknown')
  const what = t(`objective.${objectiveWord(objective)}`)
  return t(`gap.${comparison(gap, reference)}`, { what })
}

/** Whether a result is above or below its reference, proven or not. */
function comparison(gap: number, { kind }: Reference) {
  if (kind === 'proven') return gap === 0 ? 'equal' : 'above'
  if (gap === 0) return 'equalKnown'
  return gap > 0 ? 'aboveKnown' : 'belowKnown'
}
