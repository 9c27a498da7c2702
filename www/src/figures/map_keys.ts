/** Below a map in a picture: what its colours mean, and how long a kilometre is. */
import { roundLength } from '../model/metres'
import { stopsOf } from '../stage/layer_colours'
import { barWords } from '../words/metres'
import { px } from './axes'
import type { Look } from './look'
import { element } from './svg'

/** Pixels. */
const RAMP = { width: 180, height: 9 }
const BLOCK = 220
export const KEYS_HEIGHT = 52

export interface Ramp {
  id: string
  title: string
  low: string
  high: string
  colours: Uint8Array
}

/** Ramps side by side and, on a map that has a scale, a bar, of which a pixel is so much; null where there is none of them. */
export function keysOf(ramps: Ramp[], perPixel: number | null, look: Look): SVGElement | null {
  const blocks = ramps.map((ramp) => rampOf(ramp, look))
  if (perPixel !== null) blocks.push(barOf(perPixel, look))
  if (blocks.length === 0) return null
  const group = element('g', { class: 'keys' })
  blocks.forEach((block, i) => {
    block.setAttribute('transform', `translate(${i * BLOCK} 0)`)
    group.append(block)
  })
  return group
}

function rampOf({ id, title, low, high, colours }: Ramp, look: Look): SVGElement {
  const gradient = element('linearGradient', { id })
  for (const { at, colour } of stopsOf(colours))
    gradient.append(element('stop', { offset: Number(at.toFixed(4)), 'stop-color': colour }))
  const small = { y: 42, fill: look.muted, 'font-size': 11.5 }
  return element(
    'g',
    { class: 'ramp' },
    element('defs', {}, gradient),
    element('text', { y: 12 }, title),
    element('rect', { ...RAMP, y: 18, fill: `url(#${id})`, stroke: look.line }),
    element('text', small, low),
    element('text', { ...small, x: RAMP.width, 'text-anchor': 'end' }, high),
  )
}

function barOf(perPixel: number, look: Look): SVGElement {
  const long = roundLength(perPixel, RAMP.width)
  const length = px(long / perPixel)
  return element(
    'g',
    { class: 'scale-bar' },
    element('path', { d: `M0.5 18v6H${length}v-6`, fill: 'none', stroke: look.text }),
    element('text', { y: 42, fill: look.muted, 'font-size': 11.5 }, barWords(long)),
  )
}
