/** A small picture of a map, one pixel a cell; a terrain in light and shade. */
import { useEffect, useRef } from 'preact/hooks'
import { hillShade } from '../../model/hill_shade'
import { planePixels } from '../../model/map_pixels'
import type { Scenario } from '../../model/session'

/** As red, green, blue. */
const INK = { blocked: [60, 78, 71], free: [226, 232, 229], dearest: [96, 146, 150] } as const

export function Thumbnail({ scenario }: { scenario: Scenario }) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const { spec } = scenario
  useEffect(() => {
    const context = canvas.current?.getContext('2d')
    if (!context) return
    context.putImageData(new ImageData(pixelsOf(scenario), spec.width, spec.height), 0, 0)
    mark(context, spec.start, '#0b8f69')
    for (const { at } of spec.goals) mark(context, at, '#c8342b')
  }, [scenario])
  return (
    <span class="thumbnail" aria-hidden="true">
      <canvas ref={canvas} width={spec.width} height={spec.height} />
    </span>
  )
}

function pixelsOf(map: Scenario): Uint8ClampedArray<ArrayBuffer> {
  const { spec, cells, heights } = map
  if (!heights) return planePixels(map, INK)
  const pixels = hillShade(heights, spec.width, [spec.resolution, spec.resolution])
  cells.forEach((cell, at) => {
    if (cell === 1) pixels.set(INK.blocked, 4 * at)
  })
  return pixels
}

function mark(context: CanvasRenderingContext2D, [x, y]: [number, number], colour: string): void {
  const size = Math.max(1, Math.round(context.canvas.width / 16))
  context.fillStyle = colour
  context.fillRect(x - Math.floor(size / 2), y - Math.floor(size / 2), size, size)
}
