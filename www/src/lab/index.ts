/** The laboratory: everything about comparisons, in a part of the page that is fetched on demand. */
import '../styles/lab.css'
import '../styles/lab_build.css'
import '../styles/lab_run.css'
import { addLabWords } from '../i18n/lab'
import { fetchNames } from '../state/lazy_parts'
import { takeResults } from './build/take_results'
import { Lab } from './view/lab'
import { openAddress, openComparisonDocument } from './view/open_address'

export { resultFile } from './run/actions'
export { compare } from './scripting'
export { showPublished } from './view/show_published'
export { openComparisonDocument }

/** Imports a file of results. */
export async function takeImportedResults(name: string, bytes: Uint8Array): Promise<void> {
  await openAddress()
  await takeResults(name, bytes)
}

let ready: Promise<typeof Lab> | null = null

/** The view with its text. Also opens the comparison in the address, or the one this tab had open. */
export function fetchLab(): Promise<typeof Lab> {
  ready ??= Promise.all([addLabWords(), fetchNames()]).then(() => {
    void openAddress()
    return Lab
  })
  return ready
}
