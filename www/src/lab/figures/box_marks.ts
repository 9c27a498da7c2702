/** Boxes and whiskers in rows, from numbers that are computed already. */

import { HALF_BOX, MIDDLE } from './entry_rows'
import type { Plot, Scene } from './figure'

export interface Box {
  /** Which row. */
  i: number
  colour: string
  /** Ends of the whiskers. */
  low: number
  high: number
  lower: number
  median: number
  upper: number
}

export function boxMarks(plot: Plot, { look }: Scene, boxes: Box[]) {
  const across = {
    y1: ({ i }: Box) => i + MIDDLE - HALF_BOX,
    y2: ({ i }: Box) => i + MIDDLE + HALF_BOX,
  }
  const box = { ...across, x1: 'lower', x2: 'upper' }
  return [
    plot.ruleY(boxes, {
      y: ({ i }) => i + MIDDLE,
      x1: 'low',
      x2: 'high',
      stroke: 'colour',
      strokeWidth: 1.5,
    }),
    plot.rect(boxes, { ...box, fill: look.background }),
    plot.rect(boxes, {
      ...box,
      fill: 'colour',
      fillOpacity: 0.16,
      stroke: 'colour',
      strokeWidth: 1.5,
      className: 'boxes',
    }),
    plot.ruleX(boxes, { ...across, x: 'median', stroke: 'colour', strokeWidth: 3 }),
  ]
}
