/** The map as it is at the robot's step, in place of the picture of the panel's run: in the same colours, with its start, goal and cursor. */
import { type ReadonlySignal, useSignalEffect } from '@preact/signals'
import { useRef } from 'preact/hooks'
import { drawCursor, drawGrid, drawRaster } from '../drawing/draw_map'
import { drawMarks } from '../drawing/draw_marks'
import { mapPixels } from '../model/map_pixels'
import type { Scenario } from '../model/session'
import { type CanvasSize, type Cursor, lookAt } from '../stage/panel_view'
import { scenario, theme } from '../state'
import { cellsNow } from './now'

interface GroundProps {
  panelId: number
  size: ReadonlySignal<CanvasSize>
  cursor: ReadonlySignal<Cursor | null>
}

export function Ground({ panelId, size, cursor }: GroundProps) {
  const canvas = useRef<HTMLCanvasElement>(null)
  useSignalEffect(() => {
    const now = scenario.value
    const context = canvas.current?.getContext('2d')
    if (!now || !context) return
    const view = lookAt(panelId, size.value, cursor.value)
    const { width, height } = size.value
    context.canvas.width = width
    context.canvas.height = height
    // What draws in a worker draws here as well: it calls nothing that only one of the two has.
    const onto = context as unknown as OffscreenCanvasRenderingContext2D
    drawRaster(onto, view, rasterOf(now, cellsNow.value, theme.value))
    drawGrid(onto, view, now.spec)
    drawMarks(onto, view, now.spec, [])
    drawCursor(onto, view)
  })
  return <canvas ref={canvas} class="drive-ground" data-testid="drive-ground" />
}

/** The last one made: most drawings differ by the cursor alone. */
let made: { of: readonly [Scenario, Uint8Array, string]; raster: OffscreenCanvas } | null = null

function rasterOf(map: Scenario, cells: Uint8Array, look: 'light' | 'dark'): OffscreenCanvas {
  const of = [map, cells, look] as const
  if (made && of.every((part, i) => part === made?.of[i])) return made.raster
  const raster = new OffscreenCanvas(map.spec.width, map.spec.height)
  raster.getContext('2d')?.putImageData(mapPixels({ ...map, cells }, look), 0, 0)
  made = { of, raster }
  return raster
}
