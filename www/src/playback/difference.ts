/** How the pheromone of two panels differs, cell by cell. */
import { computed, effect, signal } from '@preact/signals'
import { client } from '../engine/panel_clients'
import {
  comparing,
  liveTick,
  lookedAt,
  type Panel,
  panels,
  plannerEntry,
  scenario,
  shownOf,
} from '../state'

/** Trails are fetched no more often than a reader can follow. */
const PAUSE_MS = 200

/** The panels whose planners lay pheromone. */
export const withTrails = computed(() =>
  panels.value.filter(({ setup }) => plannerEntry(setup.planner)?.layers.includes('trail')),
)

/** The panels that were chosen, by id; others stand in for those that are gone. */
export const chosen = signal<[number | null, number | null]>([null, null])

/** A and B: as chosen, else the first two. */
export const pair = computed<[Panel, Panel] | null>(() => {
  const all = withTrails.value
  const a =
    all.find(({ id }) => id === chosen.value[0]) ?? all.find(({ id }) => id !== chosen.value[1])
  const b =
    all.find(({ id }) => id === chosen.value[1] && id !== a?.id) ??
    all.find(({ id }) => id !== a?.id)
  return a && b ? [a, b] : null
})

interface Range {
  weakest: number
  strongest: number
}

/** Two trails, τ by cell, each with what it goes from and to on free cells. */
export interface Trails {
  a: Float32Array
  b: Float32Array
  ranges: [Range, Range]
  /** How far the two runs were, or were looked at, when they were asked. */
  iterations: [number, number]
}

export const trails = signal<Trails | null>(null)

/** A less B at a cell, each from 0 where it is weakest to 1 where it is strongest, as the maps are coloured: from −1 to 1. */
export function differenceAt({ a, b, ranges }: Trails, cell: number): number {
  return part(a[cell], ranges[0]) - part(b[cell], ranges[1])
}

const part = (value = 0, { weakest, strongest }: Range) =>
  strongest > weakest ? (value - weakest) / (strongest - weakest) : 0

/** Keeps the trails of both panels up to date while they are on show. */
export function keepComparing(): () => void {
  let asking = false
  let again = false
  let stopped = false
  const ask = async () => {
    asking = true
    do {
      again = false
      trails.value = await fetchTrails()
      await new Promise((resolve) => setTimeout(resolve, PAUSE_MS))
    } while (again && !stopped)
    asking = false
  }
  const stop = effect(() => {
    liveTick.value
    lookedAt.value
    pair.value?.forEach(shownOf)
    if (!comparing.value) return
    if (asking) again = true
    else void ask()
  })
  return () => {
    stopped = true
    stop()
  }
}

async function fetchTrails(): Promise<Trails | null> {
  const both = pair.peek()
  if (!both) return null
  const iterations: Trails['iterations'] = [iterationOf(both[0]), iterationOf(both[1])]
  const [a, b] = await Promise.all(
    both.map(({ id }) => client(id)?.ask({ about: 'layer', layer: 'trail' }) ?? null),
  )
  if (!a || !b || a.length === 0 || a.length !== b.length) return null
  const cells = scenario.peek()?.cells
  if (cells?.length !== a.length) return null
  return { a, b, ranges: [rangeOf(a, cells), rangeOf(b, cells)], iterations }
}

const iterationOf = ({ past, live }: Panel) => (past.peek() ?? live.peek()).summary?.iteration ?? 0

function rangeOf(values: Float32Array, cells: Uint8Array): Range {
  let [weakest, strongest] = [Number.POSITIVE_INFINITY, 0]
  for (const [cell, value] of values.entries()) {
    if (cells[cell] === 1) continue
    if (value < weakest) weakest = value
    if (value > strongest) strongest = value
  }
  return { weakest, strongest }
}
