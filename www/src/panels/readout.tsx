import { numbers, t } from '../i18n'
import { optimum, type Panel, plannerEntry } from '../state'
import { gapOf } from './gap'

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
      <RaceBar closeness={closeness(length, optimum.value)} />
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

/** Full when the path is as short as any can be: two panels' bars show who leads. */
function RaceBar({ closeness }: { closeness: number }) {
  return (
    <div class="race-bar" aria-hidden="true">
      <span style={{ transform: `scaleX(${closeness})` }} />
    </div>
  )
}

function closeness(length: number | null, best: number | null): number {
  if (length === null || best === null || !Number.isFinite(best) || length === 0) return 0
  return Math.min(1, best / length)
}

function gapWords(length: number | null, gap: number | null): string {
  if (optimum.value === Number.POSITIVE_INFINITY) return t('gap.noPathExists')
  if (length === null) return t('gap.noPathYet')
  if (gap === null) return t('gap.proving')
  return gap === 0 ? t('gap.shortest') : t('gap.above')
}
