/** Rows of a legend: a name with a word, a ramp with its least and greatest value, swatches. */
import { t } from '../i18n/reading'
import type { LayerEnds } from '../model/messages'
import { colourAt, gradient, LEAST, MOST } from './layer_colours'

export function Row({ title, note }: { title: string; note?: string }) {
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

export function Ramp({ title, note, ends, colours, write }: RampProps) {
  const [low, high] = ends.map((value) => write(isNothing(value, ends) ? 0 : value))
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

/** Beside the other end of the scale such a value is zero: what trails have evaporated to, say. */
const VANISHING = 1e-6

const isNothing = (value: number, ends: LayerEnds) =>
  Math.abs(value) < VANISHING * Math.max(...ends.map(Math.abs))

interface SwatchProps {
  title: string
  colours: Uint8Array
  categories: [least: string, greatest: string]
}

export function Swatches({ title, colours, categories: [least, greatest] }: SwatchProps) {
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
