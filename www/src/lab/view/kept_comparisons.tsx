/** The comparisons that this browser has stored; interrupted ones can go on. */
import { FolderOpen, Play, Trash2 } from 'lucide'
import { useEffect } from 'preact/hooks'
import { language, translated } from '../../i18n'
import { t } from '../../i18n/lab'
import { canKeep } from '../../model/storage'
import { notifyError } from '../../state'
import { Button, IconButton } from '../../ui/buttons'
import {
  goOn,
  keptComparisons,
  openKeptComparison,
  refreshKeptComparisons,
  removeComparison,
} from '../run/actions'
import type { StoredComparison } from '../store/browser_storage'

export function KeptComparisons() {
  const kept = keptComparisons.value
  // Another tab may have changed the list.
  useEffect(() => {
    const refresh = () => void refreshKeptComparisons()
    addEventListener('focus', refresh)
    return () => removeEventListener('focus', refresh)
  }, [])
  return (
    <section class="lab-card kept" aria-label={t('lab.kept.title')} data-testid="kept">
      <h3>{t('lab.kept.title')}</h3>
      {kept === null && (
        <p class="hint">{t(canKeep() ? 'lab.kept.unavailable' : 'lab.kept.inFile')}</p>
      )}
      {kept?.length === 0 && <p class="hint">{t('lab.kept.none')}</p>}
      {kept && kept.length > 0 && (
        <ul class="kept-list">
          {kept.map((comparison) => (
            <KeptComparison key={comparison.id} comparison={comparison} />
          ))}
        </ul>
      )}
    </section>
  )
}

function KeptComparison({ comparison }: { comparison: StoredComparison }) {
  const { id, done, total, created } = comparison
  const title = translated(comparison.title)
  const isComplete = done >= total
  const open = () => openKeptComparison(id)
  const resume = () => open().then(goOn)
  return (
    <li class="kept-item" data-testid="kept-item">
      <div class="kept-words">
        <p class="kept-title">{title}</p>
        <p class="hint">
          {!isComplete && <span class="chip status-budget-spent">{t('lab.kept.interrupted')}</span>}{' '}
          {isComplete ? t('lab.kept.done', { count: done }) : t('lab.kept.partly', { done, total })}
          {' · '}
          <time dateTime={new Date(created).toISOString()}>{dayAndTime(created)}</time>
        </p>
      </div>
      {isComplete ? (
        <Button
          icon={FolderOpen}
          label={t('lab.kept.open')}
          testId="kept-open"
          onClick={() => open().catch(notifyError)}
        />
      ) : (
        <>
          <Button
            icon={Play}
            label={t('lab.kept.goOn')}
            tone="primary"
            testId="kept-go-on"
            onClick={() => resume().catch(notifyError)}
          />
          <IconButton
            icon={FolderOpen}
            label={t('lab.kept.open')}
            tone="quiet"
            testId="kept-open"
            onClick={() => open().catch(notifyError)}
          />
        </>
      )}
      <IconButton
        icon={Trash2}
        label={t('lab.kept.remove', { title })}
        tone="quiet"
        testId="kept-remove"
        onClick={() => removeComparison(id).catch(notifyError)}
      />
    </li>
  )
}

const dayAndTime = (at: number) =>
  new Intl.DateTimeFormat(language.value, { dateStyle: 'medium', timeStyle: 'short' }).format(at)
