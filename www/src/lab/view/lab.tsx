/** The laboratory's view: the open comparison, or else the builder and the lists. */
import { LoaderCircle } from 'lucide'
import { useEffect } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { fetchWholeEngine } from '../../state'
import { embedding } from '../../state/embedding'
import { holdPresses } from '../../ui/held_press'
import { Icon } from '../../ui/icon'
import { openComparison, phase } from '../run/actions'
import { ComparisonView } from './comparison_view'
import { NothingOpen } from './nothing_open'
import { Start } from './start'

holdPresses()

export function Lab() {
  useEffect(() => {
    // Every planner can be compared, not only those of a first visit.
    void fetchWholeEngine()
  }, [])
  return (
    <main class="page lab" data-testid="lab" data-phase={phase.value}>
      {openComparison.value ? (
        <ComparisonView />
      ) : phase.value === 'opening' ? (
        <Opening />
      ) : (
        <AtRest />
      )}
    </main>
  )
}

/** In another page there is nothing to begin with: it says what is to be seen. */
const AtRest = () => (embedding ? <NothingOpen /> : <Start />)

function Opening() {
  return (
    <div class="empty" data-testid="lab-opening">
      <span class="spinner">
        <Icon icon={LoaderCircle} size={32} />
      </span>
      <p role="status">{t('lab.start.opening')}</p>
    </div>
  )
}
