/** How runs converge. The chart is fetched when there is a first curve to draw: ants should not have to wait for it. */
import type { signal } from '@preact/signals'
import { useComputed } from '@preact/signals'
import { t } from '../i18n'
import { lazily } from '../ui/lazily'
import { PanelKeys } from './panel_keys'
import { isEmpty, showIterationBest, showMean, showsCost } from './shown_curves'

const Live = lazily(async () => (await import('./convergence_chart')).fetchChart(), Nothing)

export function Convergence() {
  const empty = useComputed(isEmpty)
  return empty.value ? <Nothing /> : <Live />
}

function Nothing() {
  return (
    <>
      <ul class="legend">
        <PanelKeys />
      </ul>
      <div class="plot" data-empty={true}>
        <p class="plot-hint">{t(showsCost() ? 'chart.emptyCost' : 'chart.empty')}</p>
      </div>
    </>
  )
}

export function ConvergenceToggles() {
  return (
    <>
      <Toggle label={t('chart.iterationBest')} kind="iteration-best" of={showIterationBest} />
      <Toggle label={t('chart.mean')} kind="mean" of={showMean} />
    </>
  )
}

function Toggle(props: { label: string; kind: string; of: ReturnType<typeof signal<boolean>> }) {
  return (
    <label class="toggle">
      <input
        type="checkbox"
        checked={props.of.value}
        onChange={(event) => {
          props.of.value = event.currentTarget.checked
        }}
      />
      <span class={`line-sample ${props.kind}`} aria-hidden="true" />
      {props.label}
    </label>
  )
}
