/** How far the runs are, in the tab's name: people look at something else meanwhile. */
import { effect } from '@preact/signals'
import { t } from '../../i18n/lab'
import { phase, progress } from '../store/signals'
import { shownStudy } from '../store/translated'

export function showProgressInTitle(): void {
  effect(() => {
    const { done, total } = progress.value
    const percent = Math.floor((100 * done) / Math.max(1, total))
    const name = shownStudy.value?.title
    document.title = phase.value === 'running' ? `${percent} % · ${name}` : t('app.title')
  })
}
