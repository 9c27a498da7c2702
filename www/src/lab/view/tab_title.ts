/** The tab's title: where in Compare the reader is and, for readers who are in another tab, how far the runs are. */
import { effect } from '@preact/signals'
import { t } from '../../i18n/lab'
import { view } from '../../state'
import { isTab, nameOf } from '../results/results'
import { shownComparison } from '../store/shown_comparison'
import { shownTab } from '../store/shown_tab'
import { phase, progress } from '../store/signals'

const SITE = 'Formicarium'

export function keepTabTitle(): void {
  effect(() => {
    document.title = titleNow()
  })
}

function titleNow(): string {
  const name = shownComparison.value?.title
  if (phase.value === 'running') {
    const { done, total } = progress.value
    return `${Math.floor((100 * done) / Math.max(1, total))} % · ${name}`
  }
  if (view.value === 'race') return t('app.title')
  const tab = shownTab.value
  const parts = name ? [name, SITE] : [t('header.views.lab'), SITE]
  if (name && tab !== null && isTab(tab)) parts.unshift(nameOf(tab))
  return parts.join(' · ')
}
