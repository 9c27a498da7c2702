/** What the laboratory opens first: the comparison in the address, or what this tab had open before a reload. */
import { notifyError } from '../../state'
import { takeMapsThatCome } from '../build/draft'
import { storeDraftChanges } from '../build/stored_draft'
import { openDocument, refreshKeptComparisons, reopenInTab } from '../run/actions'
import { openComparisonLink } from '../share/open_link'
import { showProgressInTitle } from './tab_title'

let opening: Promise<void> | null = null

/** Done once, before anything else is opened. */
export function openAddress(): Promise<void> {
  opening ??= openFirst()
  return opening
}

/** Opens the text of a result file. */
export async function openComparisonDocument(text: string): Promise<void> {
  await openAddress()
  await openDocument(text)
}

async function openFirst(): Promise<void> {
  addEventListener('hashchange', () => void openComparisonLink(location.hash).catch(notifyError))
  void refreshKeptComparisons()
  takeMapsThatCome()
  storeDraftChanges()
  showProgressInTitle()
  try {
    if (!(await openComparisonLink(location.hash))) await reopenInTab()
  } catch (error) {
    notifyError(error)
  }
}
