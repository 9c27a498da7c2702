/** How runs converge. The chart is fetched when there is a first curve to draw: ants should not have to wait for it. */
import { useComputed } from '@preact/signals'
import { t } from '../i18n/column'
import { lazily } from '../ui/lazily'
import { PanelKeys } from './panel_keys'
import { isEmpty, showsCost } from './shown_curves'

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
