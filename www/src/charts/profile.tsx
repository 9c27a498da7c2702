/** How the best paths go up and down: altitude over distance, one line a panel. */
import { computed, effect, useComputed } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import type uPlot from 'uplot'
import { numbers, t } from '../i18n'
import { ground } from '../relief/shown_ground'
import { pointedPlaces } from '../stage/pointed_places'
import { notifyError, panels, scenario, selectedPanel, shownOf, slotColour, theme } from '../state'
import { panelTitle } from '../words/planner_words'
import { PanelKeys } from './panel_keys'
import { nearest, type Profile as PathProfile, profileOf } from './profile_data'

/** Curves are redrawn no more often than a reader can follow. */
const REDRAW_MS = 160

interface PanelProfile {
  panelId: number
  colour: string
  profile: PathProfile
}

/** The ground is drawn below one path only, that of the selected panel. */
const groundOf = computed(() => selectedPanel.value ?? panels.value[0]?.id)

/** Runs report several times a second; the list stays the same object until a path has changed. */
let lastSources: unknown[] = []
let lastProfiles: PanelProfile[] = []

const profiles = computed<PanelProfile[]>(() => {
  const surface = ground.value
  const bySlices = scenario.value?.spec.terrain?.slices !== undefined
  const found = panels.value.flatMap((panel) => {
    const { id, slot } = panel
    const { bestPath, bestAltitudes } = shownOf(panel)
    if (!bestPath || !bestAltitudes || bestAltitudes.length < 2) return []
    return [{ id, slot, bestPath, bestAltitudes, below: bySlices && id === groundOf.value }]
  })
  const sources = [surface, bySlices, ...found.flatMap((each) => Object.values(each))]
  if (sources.length === lastSources.length && sources.every((each, i) => each === lastSources[i]))
    return lastProfiles
  lastSources = sources
  lastProfiles = found.flatMap(({ id, slot, bestPath, bestAltitudes, below }) => {
    if (!surface) return []
    const profile = profileOf(bestPath, bestAltitudes, surface, bySlices, below)
    return [{ panelId: id, colour: slotColour(slot), profile }]
  })
  return lastProfiles
})

export function Profile() {
  const host = useRef<HTMLDivElement>(null)
  const empty = useComputed(() => profiles.value.length === 0)
  const words = useComputed(describe)
  useEffect(() => (host.current ? keepDrawn(host.current) : undefined), [])
  return (
    <>
      <Legend />
      <div class="plot" data-empty={empty}>
        <div ref={host} class="plot-host" role="img" aria-label={words} data-testid="profile" />
        <p class="plot-hint">{t('profile.empty')}</p>
      </div>
    </>
  )
}

function Legend() {
  const bySlices = scenario.value?.spec.terrain?.slices !== undefined
  return (
    <ul class="legend">
      <PanelKeys />
      {bySlices && (
        <li>
          <span class="line-sample ground" aria-hidden="true" />
          {t('profile.ground', { planner: panelTitle(groundOf.value ?? 0) })}
        </li>
      )}
    </ul>
  )
}

/** The profile in words, for screen readers, with the numbers of the table. */
function describe(): string {
  const parts = panels.value.map((panel) => {
    const planner = panelTitle(panel.id)
    const metrics = shownOf(panel).summary?.metrics
    if (!metrics?.terrain) return `${planner}: –`
    const { climb, descent } = metrics.terrain
    const metres = (value: number) => numbers.value.metres.format(value)
    return t('profile.words', {
      planner,
      length: metres(metrics.length_metres),
      climb: metres(climb),
      descent: metres(descent),
    })
  })
  return `${t('profile.title')}. ${parts.join('; ')}`
}

/** Makes the plot anew, at most every REDRAW_MS, when a path or the theme changes. */
function keepDrawn(host: HTMLElement): () => void {
  let plot: uPlot | null = null
  let timer = 0
  let closed = false
  const remake = async () => {
    timer = 0
    const { makeProfilePlot } = await import('./profile_plot')
    if (closed) return
    plot?.destroy()
    const axisLabels = { x: t('profile.distance'), y: t('profile.altitude') }
    plot = makeProfilePlot(host, profiles.peek(), { axisLabels, onHover: mark })
  }
  const stop = effect(() => {
    profiles.value
    theme.value
    t('profile.title')
    if (timer === 0) timer = window.setTimeout(() => remake().catch(notifyError), REDRAW_MS)
  })
  const resized = new ResizeObserver(() => {
    plot?.setSize({ width: Math.max(1, host.clientWidth), height: Math.max(1, host.clientHeight) })
  })
  resized.observe(host)
  return () => {
    closed = true
    clearTimeout(timer)
    stop()
    resized.disconnect()
    plot?.destroy()
    mark(null)
  }
}

/** Marks on each panel's map where its path is after this many metres. */
function mark(distance: number | null): void {
  if (distance === null) {
    if (pointedPlaces.peek().size > 0) pointedPlaces.value = new Map()
    return
  }
  pointedPlaces.value = new Map(
    profiles.peek().flatMap(({ panelId, profile }) => {
      const cell = profile.cells[nearest(profile, distance)]
      return cell ? [[panelId, cell] as const] : []
    }),
  )
}
