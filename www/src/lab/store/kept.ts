/** Experiments of this browser: which there are, and which one this tab had open. */
import { translated } from '../../i18n'
import { t } from '../../i18n/lab'
import { notify, notifyError } from '../../state'
import { forgetStudy, keptStudies, keptStudy, putStudy } from './shelf'
import { keptList } from './signals'
import { isTaken } from './tab_lock'

/** Which one this tab had open. */
export const STUDY_IN_TAB = 'formicarium.study'

export async function refreshKept(): Promise<void> {
  try {
    keptList.value = await keptStudies()
  } catch {
    keptList.value = null
  }
}

/** Takes a study off the shelf, with a way back; not while a tab is running it. */
export async function removeKept(id: string): Promise<void> {
  if (await isTaken(id)) {
    notify('warning', t('lab.run.elsewhere'))
    return
  }
  const found = await keptStudy(id)
  await forgetStudy(id)
  await refreshKept()
  if (!found) return
  const restore = () => void putStudy(found.study, found.runs).then(refreshKept).catch(notifyError)
  notify('info', t('lab.kept.removed', { title: translated(found.study.title) }), {
    action: { label: t('lab.kept.undo'), run: restore },
  })
}

/** Private windows may refuse storage. */
export function rememberInTab(key: string, id: string | null): void {
  try {
    if (id === null) sessionStorage.removeItem(key)
    else sessionStorage.setItem(key, id)
  } catch {}
}

export function recallInTab(key: string): string | null {
  try {
    return sessionStorage.getItem(key)
  } catch {
    return null
  }
}
