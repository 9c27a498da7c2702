/** A small picture of a map, one pixel a cell; a terrain in light and shade. */
import { useEffect, useRef } from 'preact/hooks'
import { hillShade } from '../../model/hill_shade'
import type { Scenario } from '../../model/session'

/** Walls and free cells, as red, green, blue, alpha. */
const BLOCKED = [60, 78, 71, 255]
const FREE = [226, 232, 229, 255]

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

function pixelsOf({ spec, cells, heights }: Scenario): Uint8ClampedArray<ArrayBuffer> {
  const { width, height, resolution } = spec
  const pixels = heights
    ? hillShade(heights, width, [resolution, resolution])
    : new Uint8ClampedArray(4 * width * height)
  cells.forEach((cell, at) => {
    if (cell === 1) pixels.set(BLOCKED, 4 * at)
    else if (!heights) pixels.set(FREE, 4 * at)
  })
  return pixels
}

function mark(context: CanvasRenderingContext2D, [x, y]: [number, number], colour: string): void {
  const size = Math.max(1, Math.round(context.canvas.width / 16))
  context.fillStyle = colour
  context.fillRect(x - Math.floor(size / 2), y - Math.floor(size / 2), size, size)
}
