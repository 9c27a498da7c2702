/** The axes of a chart that leaves the page: round numbers, quiet lines. */
import type { Look } from './look'
import { element } from './svg'

export type Ends = [low: number, high: number]

/** Where the plot lies in its picture, in pixels. */
export interface Box {
  left: number
  top: number
  right: number
  bottom: number
}

export interface Axis {
  ends: Ends
  label: string
  write: (value: number) => string
}

export interface Axes {
  /** Gridlines, numbers and labels. */
  drawn: SVGElement
  x: (value: number) => number
  y: (value: number) => number
}

const STEPS = [1, 2, 5, 10]

/** Multiples of a round step within the ends, about as many as asked for. */
export function ticks([low, high]: Ends, about: number, least = 0): number[] {
  const rough = Math.max(least, (high - low) / about)
  if (!(rough > 0)) return [low]
  const power = 10 ** Math.floor(Math.log10(rough))
  const step = power * (STEPS.find((each) => each * power >= rough * (1 - 1e-9)) ?? 10)
  const [first, last] = [Math.ceil(low / step - 1e-9), Math.floor(high / step + 1e-9)]
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step)
}

/** Pixels with two digits: more is not seen. */
export const px = (value: number) => Number(value.toFixed(2))

export function axes(box: Box, across: Axis, up: Axis, look: Look, least = 0): Axes {
  const x = scale(across.ends, box.left, box.right)
  const y = scale(up.ends, box.bottom, box.top)
  const drawn = element('g', { fill: look.muted, 'font-size': 11.5 })
  for (const value of ticks(across.ends, (box.right - box.left) / 80, least)) {
    const at = px(x(value))
    drawn.append(
      element('path', { d: `M${at} ${box.top}V${box.bottom}`, stroke: look.line }),
      element('text', { x: at, y: box.bottom + 16, 'text-anchor': 'middle' }, across.write(value)),
    )
  }
  for (const value of ticks(up.ends, (box.bottom - box.top) / 48)) {
    const at = px(y(value))
    drawn.append(
      element('path', { d: `M${box.left} ${at}H${box.right}`, stroke: look.line }),
      element('text', { x: box.left - 6, y: at + 4, 'text-anchor': 'end' }, up.write(value)),
    )
  }
  const middle = px((box.left + box.right) / 2)
  drawn.append(
    element('text', { x: middle, y: box.bottom + 36, 'text-anchor': 'middle' }, across.label),
    element('text', { x: 0, y: box.top - 10 }, up.label),
  )
  return { drawn, x, y }
}

function scale([low, high]: Ends, from: number, to: number): (value: number) => number {
  const per = high > low ? (to - from) / (high - low) : 0
  return (value) => from + (value - low) * per
}
