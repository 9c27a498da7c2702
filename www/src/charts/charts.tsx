/** The card of charts: how runs converge and, on a terrain, how their best paths go up and down. */
import { signal } from '@preact/signals'
import { t } from '../i18n'
import { onTerrain } from '../state/relief'
import { lazily } from '../ui/lazily'
import { Convergence, ConvergenceToggles } from './convergence'

const CHARTS = ['convergence', 'profile'] as const
type Chart = (typeof CHARTS)[number]

const chosen = signal<Chart>('convergence')
const Profile = lazily(async () => (await import('./profile')).fetchProfile())

const titleOf = (chart: Chart) => t(chart === 'profile' ? 'profile.title' : 'chart.title')

export function Charts() {
  const chart = onTerrain.value ? chosen.value : 'convergence'
  return (
    <section class="dock-card convergence" aria-label={titleOf(chart)}>
      <header class="dock-head">
        {onTerrain.value ? <Tabs /> : <h2>{t('chart.title')}</h2>}
        {chart === 'convergence' && <ConvergenceToggles />}
      </header>
      {chart === 'profile' ? <Profile /> : <Convergence />}
    </section>
  )
}

function Tabs() {
  return (
    <div class="chart-tabs" role="tablist" aria-label={t('profile.charts')} onKeyDown={onKeyDown}>
      {CHARTS.map((chart) => (
        <button
          key={chart}
          type="button"
          role="tab"
          id={`chart-tab-${chart}`}
          aria-selected={chosen.value === chart}
          tabIndex={chosen.value === chart ? 0 : -1}
          data-testid={`chart-${chart}`}
          onClick={() => {
            chosen.value = chart
          }}
        >
          {titleOf(chart)}
        </button>
      ))}
    </div>
  )
}

/** As in tabs, arrow keys choose the other one. */
function onKeyDown(event: KeyboardEvent): void {
  if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return
  event.preventDefault()
  event.stopPropagation()
  chosen.value = chosen.peek() === 'profile' ? 'convergence' : 'profile'
  document.getElementById(`chart-tab-${chosen.peek()}`)?.focus()
}
