/** What the further tools remember: the width of the brush, the tool used last, what ground costs, a corner set by keys, and what is about to be drawn. */
import { effect, signal } from '@preact/signals'
import { t } from '../i18n/editor'
import type { Cell } from '../model/cell'
import type { Span } from '../model/spans'
import { announce, type Tool, tool } from '../state'

/** The tools that draw walls, or tear them down; one button stands for them. */
export const WALL_TOOLS = ['wall', 'line', 'rectangle', 'block', 'fill'] as const
export type WallTool = (typeof WALL_TOOLS)[number]

export const isWallTool = (id: Tool): id is WallTool =>
  (WALL_TOOLS as readonly string[]).includes(id)

/** In which ways ground is drawn. */
export const GROUND_SHAPES = ['brush', 'line', 'rectangle', 'block', 'fill'] as const
export type DrawnShape = (typeof GROUND_SHAPES)[number]
export const groundShape = signal<DrawnShape>('brush')
/** By how much the ground that is drawn counts more than its length; these are offered. */
export const FACTORS = [1, 1.5, 2, 3, 5, 10]
export const factor = signal(3)

/** What a tool leaves in a cell: a wall, none, none on plain ground, or ground of this factor. */
export type Ink = 'wall' | 'free' | 'plain' | number

export interface Drawing {
  spans: Span[]
  ink: Ink
}

/** Cells a side. */
export const SIZES = [1, 2, 3, 5, 9]
export const brushSize = signal(1)
export const lastWallTool = signal<WallTool>('wall')

/** Whether lines go in steps of 45° and rectangles are squares: for fingers and keys what Shift is for the mouse. */
export const straight = signal(false)

/** The corner that keys have set; the next one ends the shape. */
export const corner = signal<Cell | null>(null)
/** What the press under way will draw. */
export const sketch = signal<Drawing | null>(null)

effect(() => {
  if (isWallTool(tool.value)) lastWallTool.value = tool.value
  corner.value = null
})

export function setBrushSize(size: number): void {
  brushSize.value = size
  announce(t('editor.sizeNow', { count: size }))
}

/** The next size up or down. */
export function stepBrushSize(by: 1 | -1): void {
  const at = SIZES.indexOf(brushSize.peek())
  setBrushSize(SIZES[Math.min(SIZES.length - 1, Math.max(0, at + by))] ?? 1)
}
