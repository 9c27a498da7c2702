/** What the laboratory opens by itself: what the address carries, what this tab had open, what somebody hands in. */
import { notifyError } from '../../state'
import { takeMapsThatCome } from '../build/draft'
import { keepDraft } from '../build/keep_draft'
import { openDocument, refreshKept, reopenInTab } from '../run/actions'
import { openLabFragment } from '../share/open'
import { showProgressInTitle } from './tab_title'

let opening: Promise<void> | null = null

/** Once, before anything else is opened. */
export function openAddress(): Promise<void> {
  opening ??= openFirst()
  return opening
}

/** The text of a result file. */
export async function openLabDocument(text: string): Promise<void> {
  await openAddress()
  await openDocument(text)
}

async function openFirst(): Promise<void> {
  addEventListener('hashchange', () => void openLabFragment(location.hash).catch(notifyError))
  void refreshKept()
  takeMapsThatCome()
  keepDraft()
  showProgressInTitle()
  try {
    if (!(await openLabFragment(location.hash))) await reopenInTab()
  } catch (error) {
    notifyError(error)
  }
}
