/** Signs of the ways to draw that the icon library does not have as they are meant here. */
import type { IconNode } from 'lucide'

export const LINE: IconNode = [['path', { d: 'M5 19 19 5' }]]
export const RECTANGLE: IconNode = [['rect', { x: 4, y: 5, width: 16, height: 14, rx: 1 }]]
export const BLOCK: IconNode = [
  ['rect', { x: 4, y: 5, width: 16, height: 14, rx: 1, fill: 'currentColor' }],
]
