import { Charts } from '../charts/charts'
import { t } from '../i18n'
import { Goals, goalsOnShow } from './goals'
import { MetricsTable } from './metrics_table'
import { Parameters } from './parameters'

/** Beneath the panels: how the race went, how it compares, what can be changed. */
export function Dock() {
  return (
    <div class="dock" data-goals={goalsOnShow()}>
      <Charts />
      <div class="dock-card comparison">
        <header class="dock-head">
          <h2>{t('metrics.title')}</h2>
        </header>
        <MetricsTable />
      </div>
      <Goals />
      <Parameters />
    </div>
  )
}
