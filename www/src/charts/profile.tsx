/** How the best paths go up and down: altitude over distance, one line a panel. */
import { computed, effect, useComputed } from '@preact/signals'
import type uPlot from 'uplot'
import { numbers } from '../i18n'
import { addReadingWords, t } from '../i18n/reading'
import { ground } from '../relief/shown_ground'
import { pointedPlaces } from '../stage/pointed_places'
import {
  inspected,
  panels,
  scenario,
  selectedPanel,
  shownOf,
  slotColour,
  theme,
  tool,
} from '../state'
import { panelTitle } from '../words/planner_words'
import { ChartCursor } from './chart_cursor'
import { ChartFrame } from './chart_frame'
import { keepFitting } from './chart_style'
import { PanelKeys } from './panel_keys'
import { nearest, type Profile as PathProfile, profileOf } from './profile_data'
import { makeProfilePlot } from './profile_plot'
import { ProfileReadout, pointAt, pointInWords } from './profile_readout'

const ready = () => addReadingWords()
export const fetchProfile = () => ready().then(() => Profile)

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

/** The path of which keys and presses choose cells. */
const leading = () => {
  const all = profiles.peek()
  return (all.find(({ panelId }) => panelId === groundOf.peek()) ?? all[0])?.profile
}

const placeOf = (index: number) => {
  const distances = leading()?.distances ?? []
  return distances[Math.min(distances.length - 1, Math.max(0, index))] ?? 0
}

const cursor = new ChartCursor({
  ends: () => [placeOf(0), placeOf(Number.POSITIVE_INFINITY)],
  nearest: (x) => placeOf(indexAt(x)),
  step: (from, by) => placeOf(indexAt(from) + by),
  start: () => placeOf(0),
  act: inspect,
})

function indexAt(distance: number): number {
  const profile = leading()
  return profile ? nearest(profile, distance) : 0
}

/** Looks into the cell that the leading path passes there. */
function inspect(distance: number): void {
  const all = profiles.peek()
  const led = all.find(({ panelId }) => panelId === groundOf.peek()) ?? all[0]
  const cell = led?.profile.cells[nearest(led.profile, distance)]
  if (!led || !cell) return
  tool.value = 'inspect'
  inspected.value = { panelId: led.panelId, cell, level: null }
}

function Profile() {
  const label = useComputed(
    () => `${t('cursor.profile', { chart: t('profile.title') })}. ${describe()}`,
  )
  const empty = useComputed(() => profiles.value.length === 0)
  if (empty.value) {
    return (
      <>
        <Legend />
        <div class="plot" data-empty={true}>
          <p class="plot-hint">{t('profile.empty')}</p>
        </div>
      </>
    )
  }
  const distance = cursor.at.value ?? 0
  const at = t('cursor.distance', { distance: numbers.value.metres.format(distance) })
  const points = profiles.value.map(({ panelId, colour, profile }) => ({
    panelId,
    colour,
    ...pointAt(profile, distance),
  }))
  return (
    <>
      <ProfileReadout at={at} distance={distance} points={points} />
      <ChartFrame
        testId="profile"
        picture="profile"
        cursor={cursor}
        label={label}
        ends={[placeOf(0), placeOf(Number.POSITIVE_INFINITY)]}
        at={distance}
        words={[at, ...points.map(pointInWords)].join('; ')}
        keepDrawn={keepDrawn}
      />
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
  const remake = () => {
    timer = 0
    plot?.destroy()
    const axisLabels = { x: t('profile.distance'), y: t('profile.altitude') }
    plot = makeProfilePlot(host, profiles.peek(), { axisLabels, cursor })
    cursor.refresh()
  }
  const stop = effect(() => {
    profiles.value
    theme.value
    t('profile.title')
    if (timer === 0) timer = window.setTimeout(remake, REDRAW_MS)
  })
  const stopMarking = effect(() => mark(cursor.at.value))
  const stopFitting = keepFitting(
    host,
    () => plot,
    () => cursor.refresh(),
  )
  return () => {
    clearTimeout(timer)
    stop()
    stopMarking()
    stopFitting()
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
