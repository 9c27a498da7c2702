/** What a terrain's picture has besides its cells, as the page shows it: contour lines, and hatching where there is no data. */
import { lateTools } from '../engine/late_tools'
import type { Scenario } from '../model/session'
import type { ContourData } from '../model/terrain'
import { showContours } from '../state/relief'
import { element } from './svg'

const COLOURS = {
  light: { line: '#4e3a22', hatch: '#b9c1be' },
  dark: { line: '#e8dcc4', hatch: '#33403d' },
}

/** One in so many lines is stronger. */
const MAIN = 5
/** Pixels: nearer points of a line are left out. */
const NEAREST = 0.75
const HATCH = 8

type Theme = keyof typeof COLOURS

/** To lie under the cells; null where every cell has its height. */
export function hatching(
  { spec, heights }: Scenario,
  scale: number,
  theme: Theme,
): SVGElement | null {
  if (!heights?.some(Number.isNaN)) return null
  const stroke = { stroke: COLOURS[theme].hatch, 'stroke-width': 1.3 }
  const tile = element('pattern', {
    id: 'no-data',
    width: HATCH,
    height: HATCH,
    patternUnits: 'userSpaceOnUse',
    patternTransform: 'rotate(45)',
  })
  tile.append(element('path', { d: `M${HATCH / 2} 0v${HATCH}`, ...stroke }))
  const size = { width: spec.width * scale, height: spec.height * scale }
  return element(
    'g',
    { class: 'no-data' },
    tile,
    element('rect', { ...size, fill: 'url(#no-data)' }),
  )
}

/** The lines in two strengths, and the metres from one to the next; null where none are shown. */
export async function contourLines(
  now: Scenario,
  scale: number,
  theme: Theme,
): Promise<{ lines: SVGElement; interval: number } | null> {
  const unit = now.spec.terrain?.vertical_unit
  if (!now.heights || unit === undefined || !showContours.peek()) return null
  const found = await lateTools.contours(now.spec.width, now.heights, unit)
  if (found.ends.length === 0) return null
  const { line } = COLOURS[theme]
  const lines = element('g', { class: 'contours', fill: 'none', stroke: line })
  for (const main of [false, true]) {
    const d = pathOf(found, scale, main)
    const strength = { 'stroke-width': main ? 1 : 0.6, 'stroke-opacity': main ? 0.62 : 0.36 }
    if (d !== '') lines.append(element('path', { d, 'stroke-linejoin': 'round', ...strength }))
  }
  return { lines, interval: found.interval }
}

function pathOf({ points, ends, levels }: ContourData, scale: number, main: boolean): string {
  let d = ''
  let begin = 0
  for (const [i, end] of ends.entries()) {
    if (((levels[i] ?? 0) % MAIN === 0) === main)
      d += lineOf(points.subarray(2 * begin, 2 * end), scale)
    begin = end
  }
  return d
}

function lineOf(points: Float32Array, scale: number): string {
  let d = ''
  let [lastX, lastY] = [Infinity, Infinity]
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x, y] = [(points[i] ?? 0) * scale, (points[i + 1] ?? 0) * scale]
    const isLast = i + 3 >= points.length
    if (!isLast && Math.abs(x - lastX) + Math.abs(y - lastY) < NEAREST) continue
    d += `${d === '' ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`
    ;[lastX, lastY] = [x, y]
  }
  return d
}
