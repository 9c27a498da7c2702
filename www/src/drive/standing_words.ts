/** Where the drive stands, in a sentence. */
import { t } from '../i18n/drive'
import { failure, standing } from './drive'

export function standingWords(): string {
  if (failure.value) return ''
  const now = standing.value
  if (!now) return t('drive.preparing')
  const { end, last } = now
  if (end?.kind === 'arrived') return t('drive.arrived', { count: last.step })
  if (end) return t('drive.stuck', { step: last.step, why: t(`drive.why.${end.why}`) })
  return last.did === 'start' ? t('drive.atStart') : t(`drive.${last.did}`, { step: last.step })
}
