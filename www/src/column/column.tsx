/** The column beside the maps: how the race goes, what can be changed, how it compares. Fetched once ants walk. */
import '../styles/column_part.css'
import { X } from 'lucide'
import { Charts } from '../charts/charts'
import { t } from '../i18n/column'
import { Goals } from '../panels/goals'
import { MetricsTable } from '../panels/metrics_table'
import { Parameters } from '../panels/parameters'
import { compact, lookedAt, narrow, openColumn } from '../state'
import { SeedField, SyncField } from '../toolbar/run_settings'
import { SpeedField } from '../toolbar/speed_field'
import { IconButton } from '../ui/buttons'
import { lazily } from '../ui/lazily'
import { Section } from '../ui/section'
import { ColumnEdge } from './column_edge'
import { Welcome } from './welcome'

const KeepTrails = lazily(async () => (await import('../panels/keep_trails')).fetchKeepTrails())
const PastChip = lazily(async () => (await import('../playback')).fetchPastChip())

export function Column() {
  return (
    <aside class="column-parts" aria-label={t('column.region')}>
      {compact.value ? <SheetHead /> : <ColumnEdge />}
      <div class="column-scroll">
        <Welcome />
        {compact.value && <RunSettings />}
        <Charts />
        <Parameters />
        <Goals />
        <KeepTrails />
        <Comparison />
      </div>
    </aside>
  )
}

/** A sheet lies over the maps: there must be a way to put it away within it. */
function SheetHead() {
  return (
    <header class="sheet-head">
      <h2>{t('column.region')}</h2>
      <IconButton
        icon={X}
        label={t('column.close')}
        tone="quiet"
        testId="close-column"
        onClick={() => openColumn(false)}
      />
    </header>
  )
}

/** What stands in the bars where these are wide enough. */
function RunSettings() {
  return (
    <fieldset class="run-settings" aria-label={t('run.group')}>
      <SyncField />
      {narrow.value && <SpeedField />}
      <SeedField />
    </fieldset>
  )
}

function Comparison() {
  return (
    <Section
      id="comparison"
      title={t('metrics.title')}
      class="comparison"
      tools={lookedAt.value !== null && <PastChip />}
    >
      <MetricsTable />
    </Section>
  )
}
