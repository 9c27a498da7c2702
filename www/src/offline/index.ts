/** One lazy part: the copy of the page for days without a network. */
import { addOfflineWords } from '../i18n/offline'
import { keepPage } from './keep_page'
import { OfflineSection } from './offline_section'

export { keepPage }

/** With its words. */
export async function fetchSection() {
  await addOfflineWords()
  return OfflineSection
}
