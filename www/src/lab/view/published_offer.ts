/** From a map that stands for a paper's to what can be asked of that paper. */
import { showView } from '../../state'
import { closeStudy, phase, study } from '../run/actions'
import { openAddress } from './opening'

/** The list of questions; a study that runs is not broken off for it. */
export async function showPublished(): Promise<void> {
  showView('lab')
  await openAddress()
  if (phase.peek() === 'running') return
  if (study.peek()) closeStudy()
  // Once it is drawn.
  setTimeout(() =>
    document.querySelector('.published-item.here')?.scrollIntoView({ block: 'center' }),
  )
}
