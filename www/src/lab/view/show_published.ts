/** Leads from a paper's map to the questions of that paper. */
import { showView } from '../../state'
import { closeComparison, openComparison, phase } from '../run/actions'
import { openAddress } from './open_address'

/** Shows the list of questions, unless a comparison is running. */
export async function showPublished(): Promise<void> {
  showView('lab')
  await openAddress()
  if (phase.peek() === 'running') return
  if (openComparison.peek()) closeComparison()
  // Once it is drawn.
  setTimeout(() =>
    document.querySelector('.published-item.here')?.scrollIntoView({ block: 'center' }),
  )
}
