/** What the laboratory opens first: the comparison in the address, or what this tab had open before a reload. */
import type { ToldByLink } from '../../share/comparison_link'
import { takeMapsThatCome } from '../build/draft'
import { storeDraftChanges } from '../build/stored_draft'
import { openDocument, refreshKeptComparisons } from '../run/actions'
import { followFromNow } from './address'
import { keepTabTitle } from './tab_title'

let opening: Promise<void> | null = null

/** Done once, before anything else is opened. */
export function openAddress(): Promise<void> {
  opening ??= openFirst()
  return opening
}

/** Opens the text of a result file, or what a link carries. */
export async function openComparisonDocument(text: string, told?: ToldByLink): Promise<void> {
  await openAddress()
  await openDocument(text, told)
}

async function openFirst(): Promise<void> {
  void refreshKeptComparisons()
  takeMapsThatCome()
  storeDraftChanges()
  keepTabTitle()
  await followFromNow()
}
