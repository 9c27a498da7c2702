/** Below a map in a picture: what its colours mean, and how long a kilometre is. */
import { numbers } from '../i18n'
import { t } from '../i18n/pictures'
import { stopsOf } from '../stage/layer_colours'
import { px, ticks } from './axes'
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

/** Ramps side by side and, on a map that has metres, a bar; null where there is none of them. */
export function keysOf(
  ramps: Ramp[],
  metresPerPixel: number | null,
  look: Look,
): SVGElement | null {
  const blocks = ramps.map((ramp) => rampOf(ramp, look))
  if (metresPerPixel !== null) blocks.push(barOf(metresPerPixel, look))
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

/** As long as a round number of metres. */
function barOf(metresPerPixel: number, look: Look): SVGElement {
  const metres = ticks([0, RAMP.width * metresPerPixel], 3).at(-1) ?? metresPerPixel
  const length = px(metres / metresPerPixel)
  const { metres: format } = numbers.peek()
  const words =
    metres < 1000
      ? t('pictures.metres', { value: format.format(metres) })
      : t('pictures.kilometres', { value: format.format(metres / 1000) })
  return element(
    'g',
    { class: 'scale-bar' },
    element('path', { d: `M0.5 18v6H${length}v-6`, fill: 'none', stroke: look.text }),
    element('text', { y: 42, fill: look.muted, 'font-size': 11.5 }, words),
  )
}
