import { Bug } from 'lucide'
import { t } from '../i18n'
import { comparing, panels } from '../state'
import { Icon } from '../ui/icon'
import { lazily } from '../ui/lazily'
import { AddPlannerButtons } from './add_planner'
import { PanelCard } from './panel_card'

const Difference = lazily(async () => (await import('../playback')).fetchDifference())
/** With more panels the layout is the one for this many. */
const MOST_COLUMNS = 6

export function PanelGrid() {
  const all = panels.value
  if (all.length === 0) return <NoPanels />
  return (
    <section
      class="panel-grid"
      data-count={Math.min(MOST_COLUMNS, all.length + Number(comparing.value))}
      aria-label={t('panels.region')}
    >
      {all.map((panel, index) => (
        <PanelCard key={panel.id} panel={panel} place={index + 1} />
      ))}
      {comparing.value && <Difference />}
    </section>
  )
}

function NoPanels() {
  return (
    <section class="empty" aria-label={t('panels.region')} data-testid="no-panels">
      <Icon icon={Bug} size={36} />
      <h2>{t('panels.none')}</h2>
      <p>{t('panels.noneHint')}</p>
      <AddPlannerButtons />
    </section>
  )
}
