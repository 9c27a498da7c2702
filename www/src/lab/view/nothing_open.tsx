/** In a page within another one: nothing has been asked for. */
import { ChartColumn } from 'lucide'
import { t } from '../../i18n/embed'
import { Icon } from '../../ui/icon'

export function NothingOpen() {
  return (
    <div class="empty" data-testid="lab-nothing">
      <Icon icon={ChartColumn} size={32} />
      <h2>{t('embed.noComparison')}</h2>
      <p>{t('embed.noComparisonHint')}</p>
    </div>
  )
}
