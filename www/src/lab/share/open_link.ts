/** Opens the comparison in a link. */
import { decodeFragment, PREFIX } from '../../share/comparison_link'
import { tellReceived } from '../../state/received'
import { openDocument } from '../run/actions'

/** False when the address holds no comparison. Throws a LinkError, or the engine's error, when it cannot be opened. */
export async function openComparisonLink(hash: string): Promise<boolean> {
  if (!hash.startsWith(PREFIX)) return false
  const { document, ...told } = await decodeFragment(hash)
  await openDocument(document, told)
  tellReceived()
  return true
}
