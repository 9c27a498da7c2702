/** The card of charts: how runs converge and, on a terrain, how their best paths go up and down. */
import { signal } from '@preact/signals'
import '../styles/relief.css'
import { t } from '../i18n/column'
import { onTerrain } from '../state/relief'
import { lazily } from '../ui/lazily'
import { Section } from '../ui/section'
import { Convergence } from './convergence'

const CHARTS = ['convergence', 'profile'] as const
type Chart = (typeof CHARTS)[number]

const chosen = signal<Chart>('convergence')
const Profile = lazily(async () => (await import('./profile')).fetchProfile())

const titleOf = (chart: Chart) => t(chart === 'profile' ? 'profile.title' : 'chart.title')

export function Charts() {
  const chart = onTerrain.value ? chosen.value : 'convergence'
  return (
    <Section
      id="convergence"
      title={titleOf(chart)}
      class="convergence"
      face={onTerrain.value && <Tabs />}
    >
      {chart === 'profile' ? <Profile /> : <Convergence />}
    </Section>
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
