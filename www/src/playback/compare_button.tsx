/** Opens the difference, where there are two maps of pheromone to compare. */
import { Diff } from 'lucide'
import { t } from '../i18n/playback'
import { comparing } from '../state'
import { IconButton } from '../ui/buttons'
import { withTrails } from './difference'

export function CompareButton() {
  if (withTrails.value.length < 2 && !comparing.value) return null
  return (
    <IconButton
      icon={Diff}
      label={t('playback.difference.open')}
      pressed={comparing.value}
      testId="compare-trails"
      onClick={() => {
        comparing.value = !comparing.value
      }}
    />
  )
}
