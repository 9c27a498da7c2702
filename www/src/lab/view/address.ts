/** The address of Compare: `#lab` is its beginning, `#lab/<id>/<tab>` a comparison that this browser keeps, `#q=…` one in a link. */
import { effect, untracked } from '@preact/signals'
import { notifyError, view } from '../../state'
import { arrival, goTo, place, returnedTo } from '../../state/address'
import { embedding } from '../../state/embedding'
import { isTab } from '../results/results'
import {
  closeComparison,
  openComparison,
  openKeptComparison,
  phase,
  reopenInTab,
  tellStopped,
} from '../run/actions'
import { openComparisonLink } from '../share/open_link'
import { shownTab } from '../store/shown_tab'

const START = '#lab'

/** How many addresses are being followed: meanwhile what is open does not change the address. */
let following = 0
let turn: Promise<void> = Promise.resolve()

/** Opens what the address says; from then on both go together. */
export async function followFromNow(): Promise<void> {
  await inTurn(openFirst)
  writeChanges()
  effect(() => {
    if (arrival.value) untracked(() => void inTurn(follow))
  })
}

/** `#lab` alone once stood for whatever the tab had open. */
async function openFirst(): Promise<void> {
  const isOlder = returnedTo !== START && arrival.peek() === null
  if (location.hash !== START || !isOlder) return follow()
  await reopenInTab()
  // The reader may have gone on meanwhile.
  if (place.peek() === START) goTo(fragmentNow(), 'replace')
}

function writeChanges(): void {
  let wasShown = view.peek() === 'lab'
  let written = fragmentNow()
  effect(() => {
    const isShown = view.value === 'lab'
    const fragment = fragmentNow()
    const isNew = isShown && (!wasShown || fragment !== written)
    // Who comes from the race finds what was open: that is one step, not two.
    const how = wasShown ? 'push' : 'replace'
    wasShown = isShown
    written = fragment
    if (isNew && following === 0) untracked(() => goTo(fragment, how))
  })
}

/** One after the other: who goes back several times at once ends at the last. */
function inTurn(open: () => Promise<void>): Promise<void> {
  following++
  turn = turn
    .then(open)
    .catch(notifyError)
    .then(() => {
      following--
    })
  return turn
}

async function follow(): Promise<void> {
  const fragment = location.hash
  if (view.peek() !== 'lab' || fragment === fragmentNow()) return
  if (!(await openComparisonLink(fragment)) && !embedding) {
    const [, id = '', tab = ''] = fragment.split('/')
    await show(id)
    shownTab.value = isTab(tab) ? tab : null
  }
  // It may not be there any more, and the reader may have gone on meanwhile.
  if (location.hash === fragment) goTo(fragmentNow(), 'replace')
}

/** A comparison or, without an id, the beginning. Runs under way are ended; those that are done are kept. */
async function show(id: string): Promise<void> {
  if (openComparison.peek()?.id === id) return
  if (phase.peek() === 'running') tellStopped()
  if (id !== '') await openKeptComparison(id)
  if (openComparison.peek() && openComparison.peek()?.id !== id) closeComparison()
}

function fragmentNow(): string {
  const now = openComparison.value
  if (!now) return START
  return [START, now.id, ...(shownTab.value === null ? [] : [shownTab.value])].join('/')
}
