/** The map as it is at the robot's step, in place of the picture of the panel's run: in the same colours, with its start, goal and cursor. */
import { type ReadonlySignal, useSignal, useSignalEffect } from '@preact/signals'
import { useRef } from 'preact/hooks'
import { drawCursor, drawGrid, drawHatch, drawRaster } from '../drawing/draw_map'
import { drawMarks } from '../drawing/draw_marks'
import { client } from '../engine/panel_clients'
import { mapPixels } from '../model/map_pixels'
import type { Scenario } from '../model/session'
import { type CanvasSize, type Cursor, lookAt } from '../stage/panel_view'
import { notifyError, scenario, theme } from '../state'
import { cellsNow } from './now'

interface GroundProps {
  panelId: number
  size: ReadonlySignal<CanvasSize>
  cursor: ReadonlySignal<Cursor | null>
}

export function Ground({ panelId, size, cursor }: GroundProps) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const painted = useSignal<Painted | null>(null)
  useSignalEffect(() => {
    const [now, look] = [scenario.value, theme.value]
    if (!now || !isPainted(now)) return
    pictureOf(panelId, now, look).then((picture) => {
      painted.value = picture
    }, notifyError)
  })
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
    if (isPainted(now)) drawHatch(onto, view, now.spec)
    drawRaster(onto, view, rasterOf(now, cellsNow.value, theme.value, painted.value))
    drawGrid(onto, view, now.spec)
    drawMarks(onto, view, now.spec, [])
    drawCursor(onto, view)
  })
  return <canvas ref={canvas} class="drive-ground" data-testid="drive-ground" />
}

/** The pixels of a map as the engine paints it, without walls that change. */
interface Painted {
  of: Scenario
  pixels: ImageData
}

/** Whether the engine has to be asked: how it shades heights and leaves out cells that are too narrow, it alone knows. */
const isPainted = ({ heights, spec }: Scenario) => (heights ?? spec.robot) != null

async function pictureOf(panelId: number, of: Scenario, look: Theme): Promise<Painted | null> {
  const { width, height } = of.spec
  const answer = await client(panelId)?.ask({
    about: 'picture',
    size: [width, height],
    layer: 'none',
    ends: {},
    theme: look,
  })
  return answer ? { of, pixels: new ImageData(answer.pixels, width, height) } : null
}

type Theme = 'light' | 'dark'
type Made = readonly [Scenario, Uint8Array, Theme, Painted | null]

/** The last one made: most drawings differ by the cursor alone. */
let made: { of: Made; raster: OffscreenCanvas } | null = null

function rasterOf(...of: Made): OffscreenCanvas {
  if (made && of.every((part, i) => part === made?.of[i])) return made.raster
  const [map, cells, look, painted] = of
  const raster = new OffscreenCanvas(map.spec.width, map.spec.height)
  const pixels =
    painted?.of.cells === map.cells ? painted.pixels : mapPixels({ ...map, cells }, look)
  raster.getContext('2d')?.putImageData(pixels, 0, 0)
  made = { of, raster }
  return raster
}
