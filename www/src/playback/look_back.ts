/** Which iteration all panels show, and what they had reached by then. */
import { computed, signal } from '@preact/signals'
import { client } from '../engine/panel_clients'
import { addPlaybackWords, t } from '../i18n/playback'
import { flushLive, leavePast, lookedAt, notify, type Panel, panels, pause, phase } from '../state'

/** Until they can be fetched there is English. */
addPlaybackWords().catch(() => {})

/** Some panel is still on its way to the iteration. */
export const recomputing = signal(false)

/** The runs on show whose iterations count; searches only where there is nothing else, for theirs are contours. */
export const counted = computed(() => {
  const known = panels.value.flatMap(({ live }) => live.value.summary ?? [])
  const colonies = known.filter(({ iteration_budget }) => iteration_budget !== null)
  return colonies.length > 0 ? colonies : known
})

/** The last finished iteration of the runs on show. */
export const lastIteration = computed(() =>
  Math.max(0, ...counted.value.map(({ iteration }) => iteration)),
)

export function lookBy(iterations: number): void {
  flushLive()
  const from = lookedAt.peek() ?? lastIteration.peek()
  if (lookedAt.peek() !== null || iterations < 0) lookTo(from + iterations)
}

/** Shows an iteration in all panels; the last one is where the runs stand. What plays is held. */
export function lookTo(iteration: number): void {
  // Looking back begins at what has been reached, not at what happened to be on show.
  flushLive()
  if (phase.peek() === 'running') pause()
  if (iteration >= lastIteration.peek()) {
    leavePast()
    return
  }
  lookedAt.value = Math.max(0, iteration)
  void settle()
}

let settling: Promise<void> | null = null

/** Resolves when every panel shows what is looked at. */
export function settle(): Promise<void> {
  settling ??= goThere().finally(() => {
    settling = null
    recomputing.value = false
  })
  return settling
}

/** While panels are on their way, only the newest iteration asked for is remembered. */
async function goThere(): Promise<void> {
  let shown: number | null = null
  for (let wanted = lookedAt.peek(); wanted !== shown; wanted = lookedAt.peek()) {
    shown = wanted
    if (wanted === null) continue
    recomputing.value = true
    const iteration = wanted
    const arrived = await Promise.all(panels.peek().map((panel) => show(panel, iteration)))
    if (lookedAt.peek() === iteration && !arrived.includes(true)) giveUp()
  }
}

/** No worker could look back: the part of the worker that does is fetched on demand, which may fail. */
function giveUp(): void {
  leavePast()
  notify('warning', t('playback.failed'), { hint: t('playback.failedHint') })
}

/** True when the panel shows the iteration. */
async function show(panel: Panel, iteration: number): Promise<boolean> {
  const past = await client(panel.id)?.ask({ about: 'look', iteration })
  if (!past) return false
  if (lookedAt.peek() === iteration) panel.past.value = { ...panel.live.peek(), ...past }
  return true
}
