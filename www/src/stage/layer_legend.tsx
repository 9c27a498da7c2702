/** What the colours of a panel's map mean, where it is least in the way: a ramp with its least and greatest value, or swatches. Beside it how long things are. */
import '../styles/legend.css'
import { computed, useSignal } from '@preact/signals'
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks'
import { numbers } from '../i18n'
import { addReadingWords, t } from '../i18n/reading'
import type { LegendPlace, LegendSide } from '../model/legend_place'
import type { LayerEnds, LayerScale } from '../model/messages'
import { heightRange } from '../model/relief_ground'
import { inRelief, layerEnds, panelById, sameScale, scenario, theme } from '../state'
import { categoriesOf, layerNumber, layerTitle } from '../words/layer_words'
import { barScale } from '../words/metres'
import { watchSize } from './element_size'
import { colourAt, coloursOf, gradient, LEAST, MOST } from './layer_colours'
import { followScale, scales } from './layer_scales'
import { hasRoomForBoth, held, placeBar, placeLegend } from './legend_room'
import type { CanvasSize } from './panel_view'
import { ScaleBar } from './scale_bar'

const ready = addReadingWords()
export const fetchLegend = () => ready.then(() => LayerLegend)

const heights = computed(() => scenario.value && heightRange(scenario.value))

export function LayerLegend({ panelId }: { panelId: number }) {
  useEffect(() => followScale(panelId), [panelId])
  const scale = scales.value.get(panelId)
  const range = heights.value
  if (!scale || (scale.layer === 'none' && !range && barScale.value === null)) return null
  return <Placed panelId={panelId} scale={scale} range={range} />
}

interface PlacedProps {
  panelId: number
  scale: LayerScale
  /** Of the heights, on a terrain. */
  range: LayerEnds | null
}

/** Legend and scale bar stay where they are while the map is pressed, whatever the press changes. */
function Placed({ panelId, scale, range }: PlacedProps) {
  const space = useRef<HTMLDivElement>(null)
  const size = useSignal<CanvasSize>({ width: 1, height: 1, dpr: 1 })
  const before = useRef<LegendPlace | null>(null)
  const barBefore = useRef<LegendSide | null>(null)
  useLayoutEffect(() => {
    if (!space.current) return
    return watchSize(space.current, (measured) => {
      size.value = measured
    })
  }, [])
  const coloured = scale.layer !== 'none'
  const both = coloured && range !== null && hasRoomForBoth(size.value)
  const hasLegend = coloured || range !== null
  if (!held.value) {
    const rows = both ? 2 : 1
    before.current = hasLegend ? placeLegend(size.value, rows, before.current) : null
    barBefore.current = placeBar(size.value, before.current, rows, barBefore.current)
  }
  const place = inRelief.value && hasLegend ? IN_RELIEF : before.current
  return (
    <div class="legend-space" ref={space}>
      {place && (
        <div
          class="layer-legend"
          data-shape={place.shape}
          data-side={place.side}
          data-testid={`legend-${panelId}`}
        >
          {coloured && <OfLayer panelId={panelId} scale={scale} />}
          {range && (both || !coloured) && <OfHeights range={range} />}
        </div>
      )}
      {barBefore.current && !inRelief.value && (
        <ScaleBar panelId={panelId} size={size.value} side={barBefore.current} />
      )}
    </div>
  )
}

/** There the map has no edges that one could stay clear of. */
const IN_RELIEF: LegendPlace = { shape: 'full', side: 'right-bottom' }

function OfLayer({ panelId, scale: { layer, own } }: { panelId: number; scale: LayerScale }) {
  const colours = coloursOf(layer, theme.value)
  if (layer === 'none' || !colours) return null
  const title = layerTitle(layer)
  if (!own) return <Row title={title} note={t('legend.nothing')} />
  const categories = categoriesOf(layer, panelById(panelId)?.setup.planner ?? '')
  if (categories) return <Swatches title={title} colours={colours} categories={categories} />
  const shared = sameScale.value ? layerEnds.value[layer] : undefined
  const note = shared ? t('legend.same') : undefined
  const ends = shared ?? own
  const write = layerNumber(layer)
  if (ends[0] === ends[1])
    return <Row title={title} note={t('legend.constant', { value: write(ends[0]) })} />
  return <Ramp title={title} note={note} ends={ends} colours={colours} write={write} />
}

/** Of the ground, whose tints go from its lowest cell to its highest. */
function OfHeights({ range }: { range: LayerEnds }) {
  const colours = coloursOf('none', theme.value)
  if (!colours) return null
  const write = (value: number) =>
    t('lengths.metres', { value: numbers.value.metres.format(value) })
  return <Ramp title={t('legend.heights')} ends={range} colours={colours} write={write} />
}

function Row({ title, note }: { title: string; note?: string }) {
  return (
    <p class="legend-title">
      <b>{title}</b> {note && <span>{note}</span>}
    </p>
  )
}

interface RampProps {
  title: string
  note?: string
  ends: LayerEnds
  colours: Uint8Array
  write: (value: number) => string
}

function Ramp({ title, note, ends, colours, write }: RampProps) {
  const [low, high] = ends.map(write)
  return (
    <div
      class="legend-ramp"
      role="img"
      aria-label={t('legend.words', { name: title, low, high })}
      data-low={ends[0]}
      data-high={ends[1]}
    >
      <Row title={title} note={note} />
      <span class="ramp-ends">
        <span>{low}</span>
        <span class="ramp" style={{ backgroundImage: gradient(colours) }} />
        <span>{high}</span>
      </span>
    </div>
  )
}

interface SwatchProps {
  title: string
  colours: Uint8Array
  categories: [least: string, greatest: string]
}

function Swatches({ title, colours, categories: [least, greatest] }: SwatchProps) {
  return (
    <div class="legend-swatches">
      <Row title={title} />
      <span>
        <i style={{ backgroundColor: colourAt(colours, MOST) }} /> {greatest}
      </span>
      <span>
        <i style={{ backgroundColor: colourAt(colours, LEAST) }} /> {least}
      </span>
    </div>
  )
}
