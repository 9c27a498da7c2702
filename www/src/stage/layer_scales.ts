/** What the colours of each panel's map say, and the one scale of all panels, if the reader wants one. */
import type { Layer } from '@pkg/formicarium'
import { computed, effect, signal } from '@preact/signals'
import { client } from '../engine/panel_clients'
import type { LayerEnds, LayerScale } from '../model/messages'
import { layerEnds, panels, sameScale } from '../state'

/** Numbers change no more often than a reader can follow. */
const EVERY_MS = 120

/** By panel id. */
export const scales = signal<ReadonlyMap<number, LayerScale>>(new Map())

const waiting = new Map<number, LayerScale>()
let timer = 0

/** Follows what the worker of a panel says about its colours, until it is stopped. */
export function followScale(panelId: number): () => void {
  const worker = client(panelId)
  if (!worker) return () => {}
  const take = (scale: LayerScale) => {
    waiting.set(panelId, scale)
    if (timer === 0) timer = window.setTimeout(flush, EVERY_MS)
  }
  worker.onScale = take
  if (worker.scale) take(worker.scale)
  return () => {
    if (worker.onScale === take) worker.onScale = null
  }
}

function flush(): void {
  timer = 0
  const here = new Set(panels.peek().map(({ id }) => id))
  const all = [...scales.peek(), ...waiting].filter(([id]) => here.has(id))
  waiting.clear()
  scales.value = new Map(all)
}

/** Of layers that several panels show, from the least value of any of them to the greatest. */
const common = computed(() => {
  const ends: Partial<Record<Layer, LayerEnds>> = {}
  if (!sameScale.value) return ends
  const known = new Map<Layer, LayerEnds>()
  for (const { id } of panels.value) {
    const { layer, own } = scales.value.get(id) ?? {}
    if (!layer || layer === 'none' || !own) continue
    const before = known.get(layer)
    const both: LayerEnds = before
      ? [Math.min(before[0], own[0]), Math.max(before[1], own[1])]
      : own
    if (before) ends[layer] = both
    known.set(layer, both)
  }
  return ends
})

effect(() => {
  const now = common.value
  if (JSON.stringify(now) !== JSON.stringify(layerEnds.peek())) layerEnds.value = now
})
