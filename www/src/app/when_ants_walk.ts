/** What can wait until ants walk: nothing may compete with what a visitor waits for. */
import { effect } from '@preact/signals'
import { panels, wholeEngine } from '../state'

/** A visitor whose ants do not walk by themselves waits so long for the rest. */
const SOON_MS = 1500

/** Calls once: when a run has moved, or some time after the runs have been loaded. */
export function whenAntsWalk(call: () => void): void {
  let called = false
  let timer = 0
  const once = () => {
    if (!called) call()
    called = true
  }
  effect(() => {
    if (called) return
    const efforts = panels.value.map(({ live }) => live.value.summary?.effort)
    if (efforts.some((effort) => effort && effort.ant_moves + effort.cell_expansions > 0)) once()
    else if (timer === 0 && efforts.some((effort) => effort))
      timer = window.setTimeout(once, SOON_MS)
  })
}

/** Calls once everything that a visit needs is here, and the browser has nothing to do. What it fails with is nobody's concern. */
export function whenAtRest(call: () => Promise<void>): void {
  const quietly = () => void call().catch(() => {})
  const stop = effect(() => {
    if (wholeEngine.value !== 'here') return
    queueMicrotask(() => stop())
    if ('requestIdleCallback' in window) requestIdleCallback(quietly)
    else setTimeout(quietly, SOON_MS)
  })
}
