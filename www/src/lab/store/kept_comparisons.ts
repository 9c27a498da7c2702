/** The list of comparisons that this browser has stored. */
import { translated } from '../../i18n'
import { t } from '../../i18n/lab'
import { notify, notifyError } from '../../state'
import {
  deleteComparison,
  storeComparison,
  storedComparison,
  storedComparisons,
} from './browser_storage'
import { keptComparisons } from './signals'
import { isLocked } from './tab_lock'

export async function refreshKeptComparisons(): Promise<void> {
  try {
    keptComparisons.value = await storedComparisons()
  } catch {
    keptComparisons.value = null
  }
}

/** Deletes a comparison and offers to undo it. One that a tab is running is not deleted. */
export async function removeKeptComparison(id: string): Promise<void> {
  if (await isLocked(id)) {
    notify('warning', t('lab.run.elsewhere'))
    return
  }
  const found = await storedComparison(id)
  await deleteComparison(id)
  await refreshKeptComparisons()
  if (!found) return
  const restore = () =>
    void storeComparison(found.comparison, found.runs)
      .then(refreshKeptComparisons)
      .catch(notifyError)
  notify('info', t('lab.kept.removed', { title: translated(found.comparison.title) }), {
    action: { label: t('lab.kept.undo'), run: restore },
  })
}
