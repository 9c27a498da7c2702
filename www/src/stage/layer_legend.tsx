/** What the colours of a panel's map mean, in a corner of its stage: a ramp with its least and greatest value, or swatches. */
import '../styles/legend.css'
import { computed } from '@preact/signals'
import { useEffect } from 'preact/hooks'
import { numbers } from '../i18n'
import { addReadingWords, t } from '../i18n/reading'
import type { LayerEnds, LayerScale } from '../model/messages'
import { heightRange } from '../model/relief_ground'
import { layerEnds, panelById, sameScale, scenario, theme } from '../state'
import { categoriesOf, layerTitle, scaleNumber } from '../words/layer_words'
import { colourAt, coloursOf, gradient, LEAST, MOST } from './layer_colours'
import { followScale, scales } from './layer_scales'

const ready = addReadingWords()
export const fetchLegend = () => ready.then(() => LayerLegend)

const heights = computed(() => scenario.value && heightRange(scenario.value))

export function LayerLegend({ panelId }: { panelId: number }) {
  useEffect(() => followScale(panelId), [panelId])
  const scale = scales.value.get(panelId)
  const range = heights.value
  if (!scale || (scale.layer === 'none' && !range)) return null
  return (
    <div class="legend-space">
      <div class="layer-legend" data-testid={`legend-${panelId}`}>
        {scale.layer !== 'none' && <OfLayer panelId={panelId} scale={scale} />}
        {range && <OfHeights range={range} />}
      </div>
    </div>
  )
}

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
  if (ends[0] === ends[1])
    return <Row title={title} note={t('legend.constant', { value: scaleNumber(ends[0]) })} />
  return <Ramp title={title} note={note} ends={ends} colours={colours} write={scaleNumber} />
}

/** Of the ground, whose tints go from its lowest cell to its highest. */
function OfHeights({ range }: { range: LayerEnds }) {
  const colours = coloursOf('none', theme.value)
  if (!colours) return null
  const write = (value: number) => t('legend.metres', { value: numbers.value.metres.format(value) })
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
