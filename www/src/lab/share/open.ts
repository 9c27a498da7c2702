/** Opens a comparison that a link carries. */

import { decodeFragment, PREFIX } from '../../share/comparison_link'
import { openDocument } from '../run/actions'

/** False when the address carries none. Throws a LinkError, or the engine's error, when what it carries cannot be opened. */
export async function openLabFragment(hash: string): Promise<boolean> {
  if (!hash.startsWith(PREFIX)) return false
  const document = await decodeFragment(hash)
  await openDocument(document)
  // A reload goes on with the study, instead of beginning another one.
  history.replaceState(null, '', '#lab')
  return true
}
