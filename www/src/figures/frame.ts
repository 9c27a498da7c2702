/** Title, legend, plot and notes as one picture that stands alone. */
import { FONT, type Look, type Series } from './look'
import { type SymbolName, symbolPath } from './point_symbols'
import { element, widthOf, wrapped } from './svg'

export type LegendItem =
  /** A line as it is drawn; of an area its fill. */
  | { kind: 'line'; label: string; colour: string; width: number; dash?: string }
  | { kind: 'series'; series: Series; line: boolean }
  | {
      kind: 'mark'
      mark: 'optimum' | 'published' | 'impossible' | 'box' | 'band' | 'group' | 'map'
      label: string
    }

export interface Drawing {
  plot: SVGElement
  height: number
  legend: LegendItem[]
  /** Below the plot: what it leaves out, how it is to be read. */
  notes: string[]
}

const PADDING = 16
const LEGEND_FONT = `12px ${FONT}`
const NOTE_FONT = `11.5px ${FONT}`
const LEGEND_LINE = 20
/** Pixels: the longest dashes, and the symbol that stands on their end. */
const LINE = 36
const NOTE_LINE = 16

export interface Heading {
  title: string
  subtitle: string
}

/** `heading`: for a downloaded picture; on the page the card has it. `words`: for screen readers. */
export function framed(
  drawing: Drawing,
  width: number,
  look: Look,
  words: string,
  heading: Heading | null,
): SVGSVGElement {
  const edge = heading ? PADDING : 0
  const svg = element('svg', {
    xmlns: 'http://www.w3.org/2000/svg',
    role: 'img',
    'font-family': FONT,
    'font-size': 12,
    fill: look.text,
  })
  svg.setAttribute('aria-label', words)
  const body = element('g', { transform: `translate(${edge} ${edge})` })
  let y = heading ? title(body, heading, width, look) : 0
  y += legend(body, drawing.legend, y, width, look)
  drawing.plot.setAttribute('transform', `translate(0 ${y})`)
  body.append(drawing.plot)
  y += drawing.height
  y += notes(body, drawing.notes, y, width, look)
  const [fullWidth, fullHeight] = [width + 2 * edge, Math.ceil(y) + 2 * edge]
  svg.setAttribute('width', String(fullWidth))
  svg.setAttribute('height', String(fullHeight))
  svg.setAttribute('viewBox', `0 0 ${fullWidth} ${fullHeight}`)
  if (heading) {
    svg.append(element('title', {}, heading.title), element('desc', {}, words))
    svg.append(element('rect', { width: fullWidth, height: fullHeight, fill: look.background }))
  }
  svg.append(body)
  return svg
}

function title(body: Element, heading: Heading, width: number, look: Look): number {
  const lines = wrapped(heading.title, width, `650 16px ${FONT}`)
  lines.forEach((line, i) => {
    body.append(element('text', { y: 14 + 20 * i, 'font-size': 16, 'font-weight': 650 }, line))
  })
  const top = 20 * lines.length
  const below = wrapped(heading.subtitle, width, LEGEND_FONT)
  below.forEach((line, i) => {
    body.append(element('text', { y: top + 13 + NOTE_LINE * i, fill: look.muted }, line))
  })
  return top + NOTE_LINE * below.length + 12
}

/** Pixels from the left end of an item to its words. */
const wordsAt = (item: LegendItem) => (item.kind === 'series' && item.line ? LINE + 14 : 28)

/** In as many lines as it takes. Gives its height. */
function legend(
  body: Element,
  items: LegendItem[],
  top: number,
  width: number,
  look: Look,
): number {
  let [x, y] = [0, 0]
  for (const item of items) {
    const start = wordsAt(item)
    const words = item.kind === 'series' ? item.series.label : item.label
    const lines = wrapped(words, width - start, LEGEND_FONT)
    const wide = start + Math.max(0, ...lines.map((part) => widthOf(part, LEGEND_FONT)))
    if (x > 0 && x + wide > width) [x, y] = [0, y + LEGEND_LINE]
    const group = element('g', { transform: `translate(${x} ${top + y + 10})` })
    const texts = lines.map((part, i) => element('text', { x: start, y: 4 + NOTE_LINE * i }, part))
    group.append(...sample(item, look), ...texts)
    body.append(group)
    x += wide + 16
    y += NOTE_LINE * (lines.length - 1)
  }
  return items.length === 0 ? 0 : y + LEGEND_LINE + 6
}

/** 16 pixels high; 22 wide about (11, 0), or, of a series with a line, that line and the symbol at its end. */
function sample(item: LegendItem, look: Look): SVGElement[] {
  const line = (attributes: Record<string, string | number | undefined>) =>
    element('path', {
      d: 'M0 0H22',
      fill: 'none',
      stroke: look.text,
      'stroke-width': 2,
      ...attributes,
    })
  const symbol = (name: SymbolName, attributes: Record<string, string | number | undefined>) =>
    element('path', { d: symbolPath(name, 5), transform: 'translate(11 0)', ...attributes })
  if (item.kind === 'line')
    return [
      line({ stroke: item.colour, 'stroke-width': item.width, 'stroke-dasharray': item.dash }),
    ]
  if (item.kind === 'series') {
    const { colour, dash, symbol: name } = item.series
    if (!item.line) return [symbol(name, { fill: colour })]
    return [
      line({ d: `M0 0H${LINE}`, stroke: colour, 'stroke-dasharray': dash }),
      symbol(name, { fill: colour, transform: `translate(${LINE} 0)` }),
    ]
  }
  switch (item.mark) {
    case 'optimum':
      return [line({ 'stroke-dasharray': '2 4', 'stroke-linecap': 'round' })]
    case 'published':
      return [symbol('diamond', { fill: look.background, stroke: look.text, 'stroke-width': 2 })]
    case 'impossible':
      return [symbol('diamond', { fill: look.bad, stroke: look.bad, 'stroke-width': 2 })]
    case 'box': {
      const box = { x: 3, y: -6, width: 16, height: 12, stroke: look.muted }
      return [
        element('rect', { ...box, fill: look.muted, 'fill-opacity': 0.16 }),
        element('path', { d: 'M11 -6V6', stroke: look.muted, 'stroke-width': 2.5 }),
      ]
    }
    case 'band':
      return [element('rect', { y: -6, width: 22, height: 12, fill: look.muted, opacity: 0.25 })]
    case 'group':
      return [element('path', { d: 'M11 -8V8', stroke: look.text, 'stroke-width': 4 })]
    case 'map':
      return [element('circle', { cx: 11, r: 3, fill: look.muted, opacity: 0.6 })]
  }
}

function notes(body: Element, all: string[], top: number, width: number, look: Look): number {
  const lines = all.flatMap((note) => wrapped(note, width, NOTE_FONT))
  lines.forEach((line, i) => {
    const at = { y: top + 18 + NOTE_LINE * i, fill: look.muted, 'font-size': 11.5 }
    body.append(element('text', at, line))
  })
  return lines.length * NOTE_LINE + (lines.length > 0 ? 10 : 0)
}
