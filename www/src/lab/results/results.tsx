/** What the runs of the open comparison say, in tabs. */
import '../../styles/lab_results.css'
import { computed } from '@preact/signals'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Analysis } from '../../model/analysis'
import { FormError } from '../../ui/form_error'
import { runsOfQuestion } from '../run/shares'
import { shownAnalysis } from '../store/shown_comparison'
import { shownTab } from '../store/shown_tab'
import { analysisError, openComparison, progress } from '../store/signals'
import { FiguresTab } from './figures_tab'
import { FilesTab } from './files_tab'
import { FrontsTab } from './fronts_tab'
import { MatrixTab } from './matrix_tab'
import { hasReported, ReportedTab } from './reported_tab'
import { SummaryTab } from './summary_tab'
import { TabPanel, Tabs } from './tabs'
import { TestsTab } from './tests_tab'
import { UnitLine } from './unit_line'

const TABS = ['matrix', 'summary', 'figures', 'fronts', 'tests', 'reported', 'files'] as const
type Tab = (typeof TABS)[number]

/** Whether there is a tab of this name. */
export const isTab = (name: string): name is Tab => TABS.some((tab) => tab === name)

/** From a map of the overview to all of its numbers. */
const showSummary = () => {
  shownTab.value = 'summary'
}

const BODIES = {
  matrix: ({ analysis }: { analysis: Analysis }) => (
    <MatrixTab analysis={analysis} onMap={showSummary} />
  ),
  summary: SummaryTab,
  figures: FiguresTab,
  fronts: FrontsTab,
  tests: TestsTab,
  reported: ReportedTab,
  files: FilesTab,
}

export function Results() {
  const now = shownAnalysis.value
  if (!openComparison.value) return null
  const tabs = TABS.filter((tab) => tab !== 'reported' || (now !== null && hasReported(now)))
  const tab = tabs.find((each) => each === shownTab.value) ?? 'matrix'
  const Body = BODIES[tab]
  return (
    <section class="lab-card results" aria-label={t('lab.results.title')} data-testid="results">
      {openComparison.value.share && <PartOfAll />}
      <UnitLine />
      <Tabs
        label={t('lab.results.title')}
        name="results"
        tabs={tabs.map((id) => ({ id, label: nameOf(id) }))}
        chosen={tab}
        onChoose={(id) => {
          shownTab.value = id
        }}
      />
      <TabPanel name="results" chosen={tab}>
        {now && (begun.value || hasGiven(now)) ? <Body analysis={now} /> : <Nothing />}
      </TabPanel>
    </section>
  )
}

/** A share of a class shows a part of the runs: how large it is. */
function PartOfAll() {
  // It grows with every run.
  progress.value
  const { all, there } = runsOfQuestion()
  const done = numbers.value.whole.format(there)
  return (
    <p class="hint results-part" data-testid="part-of-all">
      {t('lab.class.ofAll', { done, count: all })}
    </p>
  )
}

/** What a tab is called. */
export const nameOf = (tab: Tab) =>
  tab === 'matrix' || tab === 'fronts' ? t(`lab.${tab}.tab`) : t(`lab.results.tabs.${tab}`)

/** Whether any run is done. The number of them changes more often than anything here should be drawn. */
const begun = computed(() => progress.value.done > 0)

/** Imported results are shown before any run is done here. */
const hasGiven = ({ instances }: Analysis) =>
  instances.some(({ entries }) =>
    entries.some(({ origin, runs }) => origin === 'results' && runs > 0),
  )

function Nothing() {
  if (analysisError.value) return <FormError error={analysisError.value} />
  return <p class="results-nothing">{t(begun.value ? 'common.working' : 'lab.results.nothing')}</p>
}
