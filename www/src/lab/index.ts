/** The laboratory: everything about comparisons, in a part of the page that is fetched on demand. */
import '../styles/lab.css'
import '../styles/lab_build.css'
import '../styles/lab_run.css'
import { addLabWords } from '../i18n/lab'
import { addReadingsWords } from '../i18n/readings'
import type { UnreadFile } from '../state/file_bytes'
import { fetchNames } from '../state/lazy_parts'
import { joinFile, takeResults } from './build/take_results'
import { takeJournals } from './run/journals'
import { Lab } from './view/lab'
import { openAddress, openComparisonDocument } from './view/open_address'

export { compare, resultFile } from './scripting'
export { AboutComparison } from './share/about_comparison'
export { fragmentOfNow } from './share/link_of_now'
export { showPublished } from './view/show_published'
export { openComparisonDocument }

/** Imports a file of results. */
export async function takeImportedResults(name: string, bytes: Uint8Array): Promise<void> {
  await openAddress()
  await takeResults(name, bytes)
}

/** The same for a script: what is refused is thrown. */
export async function joinForScript(
  name: string,
  bytes: Uint8Array,
  instance: string | undefined,
  leaveOut: string[],
): Promise<void> {
  await fetchLab()
  await openAddress()
  const place = instance === undefined ? {} : { instance: { id: instance, name: instance } }
  await joinFile(name, bytes, { leaveOut, ...place })
}

/** Takes the runs of journals into the comparison that is open. */
export async function takeJournalFiles(files: UnreadFile[]): Promise<void> {
  await fetchLab()
  await openAddress()
  await takeJournals(files)
}

let ready: Promise<typeof Lab> | null = null

/** The view with its text. Also opens the comparison in the address, or the one this tab had open. */
export function fetchLab(): Promise<typeof Lab> {
  ready ??= Promise.all([addLabWords(), addReadingsWords(), fetchNames()]).then(
    () => {
      void openAddress()
      return Lab
    },
    (error: unknown) => {
      ready = null
      throw error
    },
  )
  return ready
}
