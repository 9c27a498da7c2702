/** What a press would do, over the map: the cells it changes, the selection and its handles. Workers draw none of it. */
import { type ReadonlySignal, useSignalEffect } from '@preact/signals'
import { useRef } from 'preact/hooks'
import type { Cell } from '../model/cell'
import { type Area, areaBetween } from '../model/spans'
import type { Placement } from '../model/viewpoint'
import { PLAIN } from '../model/weights'
import { type CanvasSize, type Cursor, place } from '../stage/panel_view'
import { scenario, theme, tool } from '../state'
import { corner, type Drawing, groundShape, type Ink, sketch } from './hand'
import { selection } from './selection'
import { wouldDraw } from './shapes'

interface PreviewProps {
  size: ReadonlySignal<CanvasSize>
  cursor: ReadonlySignal<Cursor | null>
}

const COLOURS = {
  light: {
    wall: '#3d4451b0',
    free: '#fbfaf7d0',
    ground: '#427a7eb0',
    edge: '#1d6fd1',
    ring: '#ffffff',
  },
  dark: {
    wall: '#6a7486c0',
    free: '#12151bd0',
    ground: '#4a8e8cc0',
    edge: '#6fb1ff',
    ring: '#0c1211',
  },
}
/** Above this many cells nothing is filled for show: it would be searched with every move of the pointer. */
const MOST_SHOWN = 1 << 18

export function EditPreview({ size, cursor }: PreviewProps) {
  const canvas = useRef<HTMLCanvasElement>(null)
  useSignalEffect(() => {
    const { width, height, dpr } = size.value
    const context = canvas.current?.getContext('2d')
    if (!canvas.current || !context) return
    if (canvas.current.width !== width) canvas.current.width = width
    if (canvas.current.height !== height) canvas.current.height = height
    context.clearRect(0, 0, width, height)
    const onto = { context, placement: place(size.value), dpr, colours: COLOURS[theme.value] }
    const at = cursor.value?.cell ?? null
    const cells = sketch.value ?? hovered(at)
    if (cells) drawCells(onto, cells)
    const area = corner.value && tool.value === 'select' ? marked(at) : selection.value
    if (area) drawArea(onto, area)
  })
  return (
    <div class="edit-preview" aria-hidden="true">
      <canvas ref={canvas} />
    </div>
  )
}

function hovered(at: Cell | null): Drawing | null {
  const small = (scenario.value?.cells.length ?? 0) <= MOST_SHOWN
  return at && (small || !isFilling()) ? wouldDraw(at) : null
}

const isFilling = () =>
  tool.value === 'fill' || (tool.value === 'ground' && groundShape.value === 'fill')

/** Between the corner that keys have set and the cursor. */
const marked = (at: Cell | null): Area | null =>
  corner.value && areaBetween(corner.value, at ?? corner.value)

interface Onto {
  context: CanvasRenderingContext2D
  placement: Placement
  dpr: number
  colours: (typeof COLOURS)['light']
}

function drawCells(onto: Onto, { spans, ink }: Drawing): void {
  const { context, placement, colours } = onto
  const { scale, originX, originY } = placement
  // One path, so that cells that overlap are not darker than others.
  context.beginPath()
  for (const { y, from, to } of spans)
    context.rect(originX + from * scale, originY + y * scale, (to - from + 1) * scale, scale)
  context.fillStyle = colours[lookOf(ink)]
  context.fill()
}

/** Plain ground looks free. */
function lookOf(ink: Ink): 'wall' | 'free' | 'ground' {
  if (ink === 'wall') return ink
  return typeof ink === 'number' && ink > PLAIN ? 'ground' : 'free'
}

function drawArea({ context, placement, dpr, colours }: Onto, area: Area): void {
  const { scale, originX, originY } = placement
  const [left, top] = [originX + area.x * scale, originY + area.y * scale]
  const [wide, high] = [area.width * scale, area.height * scale]
  for (const [colour, width, dash] of [
    [colours.ring, 4, []],
    [colours.edge, 2, [6 * dpr, 4 * dpr]],
  ] as const) {
    context.strokeStyle = colour
    context.lineWidth = width * dpr
    context.setLineDash([...dash])
    context.strokeRect(left, top, wide, high)
  }
  context.setLineDash([])
  const side = 9 * dpr
  for (const x of [left, left + wide])
    for (const y of [top, top + high]) {
      context.fillStyle = colours.edge
      context.fillRect(x - side / 2, y - side / 2, side, side)
      context.strokeStyle = colours.ring
      context.lineWidth = 1.5 * dpr
      context.strokeRect(x - side / 2, y - side / 2, side, side)
    }
}
