/** What the colours of a panel's map mean, where it is least in the way: a ramp with its least and greatest value, or swatches. Beside it how long things are. */
import '../state/weighted_optimum'
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
import { startGroundWords, weightEnds } from './felt_ground'
import { coloursOf } from './layer_colours'
import { followScale, scales } from './layer_scales'
import { hasRoomForBoth, held, placeBar, placeLegend } from './legend_room'
import { Ramp, Row, Swatches } from './legend_rows'
import type { CanvasSize } from './panel_view'
import { ScaleBar } from './scale_bar'
import { OfWeights } from './weights_legend'

const ready = () => Promise.all([addReadingWords(), startGroundWords()])
export const fetchLegend = () => ready().then(() => LayerLegend)

/** Of the heights of a terrain, of the factors of weighted ground. */
const ground = computed(() => {
  const now = scenario.value
  return now && (heightRange(now) ?? weightEnds.value)
})

export function LayerLegend({ panelId }: { panelId: number }) {
  useEffect(() => followScale(panelId), [panelId])
  const scale = scales.value.get(panelId)
  const range = ground.value
  if (!scale || (scale.layer === 'none' && !range && barScale.value === null)) return null
  return <Placed panelId={panelId} scale={scale} range={range} />
}

interface PlacedProps {
  panelId: number
  scale: LayerScale
  /** Of what the ground's tints tell; null where it has none. */
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
          {range && (both || !coloured) && <OfGround range={range} />}
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

const OfGround = ({ range }: { range: LayerEnds }) =>
  scenario.value?.heights ? <OfHeights range={range} /> : <OfWeights range={range} />

/** Of the ground, whose tints go from its lowest cell to its highest. */
function OfHeights({ range }: { range: LayerEnds }) {
  const colours = coloursOf('none', theme.value)
  if (!colours) return null
  const write = (value: number) =>
    t('lengths.metres', { value: numbers.value.metres.format(value) })
  return <Ramp title={t('legend.heights')} ends={range} colours={colours} write={write} />
}
