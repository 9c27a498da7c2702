/** Shows the progress of the runs in the tab's title, for readers who are in another tab. */
import { effect } from '@preact/signals'
import { t } from '../../i18n/lab'
import { shownComparison } from '../store/shown_comparison'
import { phase, progress } from '../store/signals'

export function showProgressInTitle(): void {
  effect(() => {
    const { done, total } = progress.value
    const percent = Math.floor((100 * done) / Math.max(1, total))
    const name = shownComparison.value?.title
    document.title = phase.value === 'running' ? `${percent} % · ${name}` : t('app.title')
  })
}
