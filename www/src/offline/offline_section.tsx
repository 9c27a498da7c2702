/** Whether the page is kept for days without a network, and what can be done about it. */
import { t } from '../i18n/offline'
import { notifyError } from '../state'
import { Button } from '../ui/buttons'
import { changesOf } from './changes'
import { copy, dropCopy, keeping, megabytes, useNewer, wantCopy } from './keep_page'

export function OfflineSection() {
  const kept = copy.value
  return (
    <section data-testid="offline" data-keeping={keeping.value}>
      <h3>{t('offline.title')}</h3>
      <p role="status">
        {t(`offline.states.${keeping.value}`, { size: kept ? megabytes(kept.bytes) : '' })}
      </p>
      {kept?.newer && (
        <p>
          {t('offline.newer')} {changesOf(kept.used, kept.newer)}
        </p>
      )}
      <p class="button-row">
        {kept?.newer && (
          <Button
            label={t('offline.use')}
            tone="primary"
            testId="offline-use"
            onClick={() => useNewer().catch(notifyError)}
          />
        )}
        {keeping.value === 'kept' && (
          <Button
            label={t('offline.drop')}
            testId="offline-drop"
            onClick={() => dropCopy().catch(notifyError)}
          />
        )}
        {(keeping.value === 'off' || keeping.value === 'failed') && (
          <Button
            label={t('offline.keep')}
            testId="offline-keep"
            onClick={() => wantCopy().catch(notifyError)}
          />
        )}
      </p>
    </section>
  )
}
