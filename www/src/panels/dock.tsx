import { Charts } from '../charts/charts'
import { t } from '../i18n'
import { lookedAt } from '../state'
import { lazily } from '../ui/lazily'
import { Goals } from './goals'
import { goalsOnShow } from './goals_shown'
import { MetricsTable } from './metrics_table'
import { Parameters } from './parameters'

const PastChip = lazily(async () => (await import('../playback')).fetchPastChip())

/** Beneath the panels: how the race went, how it compares, what can be changed. */
export function Dock() {
  return (
    <div class="dock" data-goals={goalsOnShow()}>
      <Charts />
      <div class="dock-card comparison">
        <header class="dock-head">
          <h2>{t('metrics.title')}</h2>
          {lookedAt.value !== null && <PastChip />}
        </header>
        <MetricsTable />
      </div>
      <Goals />
      <Parameters />
    </div>
  )
}
