/** Small helpers for drawing SVG: elements, the width of text, lines of words. */

const NAMESPACE = 'http://www.w3.org/2000/svg'

/** No Char of XML 1.0 (2.2): control characters, halves of surrogate pairs, U+FFFE and U+FFFF; not even as a reference. */
const NOT_IN_XML = /[^\t\n\r\u{20}-\u{d7ff}\u{e000}-\u{fffd}\u{10000}-\u{10ffff}]/gu

export type Attributes = Record<string, string | number | undefined>

export function element<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): SVGElementTagNameMap[K] {
  const made = document.createElementNS(NAMESPACE, name)
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined) made.setAttribute(key, String(value))
  }
  made.append(...children)
  return made
}

let ruler: CanvasRenderingContext2D | null = null

/** Width of a line of text in pixels. */
export function widthOf(text: string, font: string): number {
  ruler ??= document.createElement('canvas').getContext('2d')
  if (!ruler) return 7 * text.length
  ruler.font = font
  return ruler.measureText(text).width
}

/** Text, cut where it would be wider than this many pixels. */
export function shortened(text: string, most: number, font: string): string {
  if (widthOf(text, font) <= most) return text
  let kept = text.length
  while (kept > 1 && widthOf(`${text.slice(0, kept)}…`, font) > most) kept--
  return `${text.slice(0, kept).trimEnd()}…`
}

/** The size of letters at which a text fits, and what is left of it where that would be less than `least` of the size. */
export function fitting(
  text: string,
  most: number,
  size: number,
  font: (size: number) => string,
  least = 0.7,
): { text: string; size: number } {
  const wide = widthOf(text, font(size))
  if (wide <= most) return { text, size }
  const smaller = Math.max(least * size, (size * most) / wide)
  return { text: shortened(text, most, font(smaller)), size: smaller }
}

/** Words in lines of at most this many pixels. Chinese may break anywhere. */
export function wrapped(text: string, most: number, font: string): string[] {
  const words =
    text.match(/(?:[\u3000-\u9fff\uff00-\uffef]|[^\s\u3000-\u9fff\uff00-\uffef]+)\s*/g) ?? []
  const lines: string[] = []
  let line = ''
  for (const word of words) {
    if (line !== '' && widthOf((line + word).trimEnd(), font) > most) {
      lines.push(line.trimEnd())
      line = ''
    }
    line += word
  }
  if (line !== '') lines.push(line.trimEnd())
  return lines
}

/** As a file that stands alone. Names come from files, and the serializer writes what no XML may hold as it is. */
export function svgText(svg: SVGSVGElement): string {
  const text = new XMLSerializer().serializeToString(svg).replace(NOT_IN_XML, '\ufffd')
  return `<?xml version="1.0" encoding="UTF-8"?>\n${text}\n`
}
