/**
 * What the workers report, gathered and handed to the page at most about eight times a second: the
 * canvases move every frame in their workers, numbers need not.
 */
import { batch } from '@preact/signals'
import type { PanelReply } from '../model/messages'
import { HistoryRows } from './history_rows'
import { blankLive, liveTick, type PanelLive, panelById, pressed } from './store'

const FLUSH_MS = 120
const histories = new Map<number, HistoryRows>()
const pending = new Map<number, PanelLive>()
let timer = 0

export function historyOf(panelId: number): HistoryRows {
  let rows = histories.get(panelId)
  if (!rows) {
    rows = new HistoryRows()
    histories.set(panelId, rows)
  }
  return rows
}

/** What a panel's run has reached, including what has not been shown yet. */
export function latest(panelId: number): PanelLive {
  return pending.get(panelId) ?? panelById(panelId)?.live.peek() ?? blankLive()
}

/** The one way in for everything a panel's worker says. */
export function onReply(panelId: number, reply: PanelReply): void {
  const panel = panelById(panelId)
  if (!panel || !('runId' in reply || reply.kind === 'failed')) return
  const before = latest(panelId)
  if (reply.kind === 'frame') {
    historyOf(panelId).append(reply.history)
    const { summary } = reply
    pending.set(panelId, {
      ...before,
      summary,
      objective: summary.objective,
      bestPath: reply.bestPath ?? before.bestPath,
      bestAltitudes: reply.bestAltitudes ?? before.bestAltitudes,
      error: null,
      crashed: null,
    })
  } else if (reply.kind === 'refused') {
    pending.set(panelId, { ...before, objective: null, error: reply.error })
  } else {
    pending.set(panelId, { ...before, crashed: reply.error })
  }
  schedule()
}

/** Forget a run that is being replaced. */
export function clearLive(panelId: number): void {
  historyOf(panelId).clear()
  pending.delete(panelId)
  const panel = panelById(panelId)
  if (!panel) return
  const { verified, objective } = panel.live.peek()
  panel.live.value = { ...blankLive(), verified, objective }
}

export function forget(panelId: number): void {
  histories.delete(panelId)
  pending.delete(panelId)
}

export function setVerified(panelId: number, verified: PanelLive['verified']): void {
  const panel = panelById(panelId)
  if (!panel) return
  const waiting = pending.get(panelId)
  if (waiting) pending.set(panelId, { ...waiting, verified })
  panel.live.value = { ...panel.live.peek(), verified }
}

/** Not while a pointer draws: no number may push the map from under it. */
export function flushLive(): void {
  clearTimeout(timer)
  timer = 0
  if (pressed.peek()) return
  batch(() => {
    for (const [panelId, live] of pending) {
      const panel = panelById(panelId)
      if (panel) panel.live.value = live
    }
    pending.clear()
    liveTick.value = liveTick.peek() + 1
  })
}

function schedule(): void {
  if (timer === 0) timer = window.setTimeout(flushLive, FLUSH_MS)
}
