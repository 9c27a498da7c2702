/** The cells of a map in the colours of the stage, with its start and goals: those lie over it, so that no edge cuts them. */
import '../styles/map_ends.css'
import { useEffect, useRef } from 'preact/hooks'
import type { Cell } from '../model/cell'
import { type MapToShow, mapPixels } from '../model/map_pixels'
import { theme } from '../state'

interface PictureProps {
  map: MapToShow
  /** Absent where the words beside it say enough. */
  label?: string
  /** Whether start and goals are shown. */
  ends?: boolean
}

export function MapPicture({ map, label, ends = false }: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const ink = theme.value
  useEffect(
    () => canvas.current?.getContext('2d')?.putImageData(mapPixels(map, ink), 0, 0),
    [map, ink],
  )
  const { width, height, start, goals } = map.spec
  // Small ones stay crisp squares; of large ones averaging keeps thin walls in sight.
  const rendering = Math.max(width, height) < 256 ? 'pixelated' : 'auto'
  const place = ([x, y]: Cell) => ({
    left: `${(100 * (x + 0.5)) / width}%`,
    top: `${(100 * (y + 0.5)) / height}%`,
  })
  return (
    <>
      <canvas
        ref={canvas}
        width={width}
        height={height}
        style={{ imageRendering: rendering }}
        role={label ? 'img' : 'presentation'}
        aria-label={label}
      />
      {ends && goals.map(({ at }) => <i key={at.join()} class="map-end goal" style={place(at)} />)}
      {ends && <i class="map-end start" style={place(start)} />}
    </>
  )
}
