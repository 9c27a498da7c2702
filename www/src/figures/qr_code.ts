/** Links as QR codes, in black on white whatever lies around them: readers of codes want it so. */
import { element } from './svg'

/** Bytes that the largest code holds: version 40 with the least error correction (ISO/IEC 18004, table 7). */
export const MOST_QR_BYTES = 2953

/** White around a code, in modules. */
const QUIET = 4

export interface QrCode {
  /** Modules a side, without the quiet zone and with it. */
  modules: number
  size: number
  /** The dark modules, for a field of `size` × `size`. */
  d: string
  text: string
}

export const fitsQrCode = (text: string) => new TextEncoder().encode(text).length <= MOST_QR_BYTES

/** Null where the text is longer than a code holds. The library is fetched with the first one. */
export async function qrCode(text: string): Promise<QrCode | null> {
  if (!fitsQrCode(text)) return null
  const { encode } = await import('uqr')
  const { data, size } = encode(text, { ecc: 'L', border: QUIET, boostEcc: true })
  return { modules: size - 2 * QUIET, size, d: data.map(runsOf).join(''), text }
}

/** Dark modules that lie side by side are one rectangle: fewer shapes, no seams. */
function runsOf(row: boolean[], y: number): string {
  let d = ''
  for (let x = 0; x < row.length; x++) {
    if (!row[x]) continue
    const start = x
    while (row[x + 1]) x++
    d += `M${start} ${y}h${x - start + 1}v1h${start - x - 1}z`
  }
  return d
}

/** A square of `side` pixels. */
export function qrElement({ size, d }: QrCode, side: number, x = 0, y = 0): SVGElement {
  return element(
    'g',
    {
      class: 'qr-code',
      transform: `translate(${x} ${y}) scale(${side / size})`,
      'shape-rendering': 'crispEdges',
    },
    element('rect', { width: size, height: size, fill: '#ffffff' }),
    element('path', { d, fill: '#000000' }),
  )
}

/** The code alone, as a picture that stands alone; `label` is for screen readers. */
export function qrSvg(code: QrCode, side: number, label: string): SVGSVGElement {
  const svg = element(
    'svg',
    {
      xmlns: 'http://www.w3.org/2000/svg',
      role: 'img',
      width: side,
      height: side,
      viewBox: `0 0 ${side} ${side}`,
    },
    element('title', {}, label),
    qrElement(code, side),
  )
  svg.setAttribute('aria-label', label)
  return svg
}

type Canvas = Pick<
  OffscreenCanvasRenderingContext2D,
  'fill' | 'fillRect' | 'fillStyle' | 'save' | 'restore' | 'scale' | 'translate'
>

/** In whole pixels a module, in the middle of a square of `most` pixels; false where a module would be less than two of them. */
export function drawQrCode(
  context: Canvas,
  { size, d }: QrCode,
  x: number,
  y: number,
  most: number,
): boolean {
  const module = Math.floor(most / size)
  if (module < 2) return false
  const rest = Math.floor((most - module * size) / 2)
  context.save()
  context.translate(Math.round(x) + rest, Math.round(y) + rest)
  context.fillStyle = '#ffffff'
  context.fillRect(0, 0, module * size, module * size)
  context.scale(module, module)
  context.fillStyle = '#000000'
  context.fill(new Path2D(d))
  context.restore()
  return true
}

/** Pixels about a code in the corner of a picture, and the least side of such a code. */
const CORNER = { edge: 16, least: 160 }
/** Pixels a module at least: in a PNG of twice the size it is four. */
const LEAST_MODULE = 2

/** A picture with a code in its lower right corner, below all else, and words beside it. */
export function withCode(svg: SVGSVGElement, code: QrCode, words: string[]): SVGSVGElement {
  const [width, height] = [svg.width.baseVal.value, svg.height.baseVal.value]
  const side = code.size * Math.max(LEAST_MODULE, Math.round(CORNER.least / code.size))
  const tall = height + side + CORNER.edge
  const x = width - side - CORNER.edge
  svg.setAttribute('height', String(tall))
  svg.setAttribute('viewBox', `0 0 ${width} ${tall}`)
  svg.querySelector(':scope > rect')?.setAttribute('height', String(tall))
  svg.append(element('metadata', {}, code.text), qrElement(code, side, x, height))
  words.forEach((line, i) => {
    const at = { x: x - CORNER.edge, y: height + side - 6 - 18 * (words.length - 1 - i) }
    svg.append(element('text', { ...at, 'text-anchor': 'end', 'font-size': 12 }, line))
  })
  return svg
}
