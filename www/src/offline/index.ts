/** One lazy part: the copy of the page for days without a network. */
import { addOfflineWords } from '../i18n/offline'
import { keepPage } from './keep_page'
import { openLaunched } from './launched_files'
import { OfflineSection } from './offline_section'

/** What a page does for its reader's system once it has nothing else to do. */
export function startResting(): Promise<void> {
  openLaunched()
  return keepPage()
}

/** With its words. */
export async function fetchSection() {
  await addOfflineWords()
  return OfflineSection
}
