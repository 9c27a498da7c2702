/** The surface of the terrain on show and its exaggeration, shared by all panels. */
import { computed, signal } from '@preact/signals'
import { Ground } from '../model/relief_ground'
import { scenario } from '../state'

/** What the reader has chosen; null: the default of the map. */
const chosen = signal<{ heights: Float32Array; times: number } | null>(null)

let last: { key: unknown[]; ground: Ground } | null = null

/** The same object as long as heights and scale are the same: edits of the walls leave it alone. */
export const ground = computed<Ground | null>(() => {
  const now = scenario.value
  if (!now?.heights) return null
  const { spec, heights } = now
  const key = [heights, spec.width, spec.resolution, spec.terrain?.vertical_unit]
  if (!last || last.key.some((part, i) => part !== key[i])) last = { key, ground: new Ground(now) }
  return last.ground
})

/** Share of the longer side that the relief takes by default. */
const RELIEF = 0.17
const MOST = 10

/** The exaggerations on offer. Ground that is steeper than anybody can look at is flattened instead. */
export const stretches = computed(() => {
  const now = ground.value
  const wanted = now && now.span > 0 ? (RELIEF * Math.max(now.width, now.height)) / now.span : 1
  if (wanted < 0.4) return { least: wanted, most: MOST * wanted, step: wanted / 2, usual: wanted }
  const usual = Math.min(MOST, Math.max(1, Math.round(wanted * 2) / 2))
  return { least: 1, most: MOST, step: 0.5, usual }
})

export const stretch = computed(() => {
  const mine = chosen.value
  return mine && mine.heights === scenario.value?.heights ? mine.times : stretches.value.usual
})

export function chooseStretch(times: number): void {
  const heights = scenario.peek()?.heights
  if (heights) chosen.value = { heights, times }
}
