/** The cells of a map before it is opened, in the colours of the stage. */
import type { Imported } from '@pkg/formicarium'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { heightsOf } from '../model/height_bytes'
import { hillShade } from '../model/hill_shade'
import { theme } from '../state'

/** As the workers paint them (src/wasm/paint.rs), little-endian. */
const INK = {
  light: { free: 0xff_f7_fa_fb, blocked: 0xff_51_44_3d },
  dark: { free: 0xff_1b_15_12, blocked: 0xff_64_54_4b },
}

/** `busy`: it is about to change. */
export function MapPreview({ map, busy }: { map: Imported | null; busy: boolean }) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const ink = theme.value
  useEffect(() => draw(canvas.current, map, ink), [map, ink])
  const { width, height } = map?.spec ?? { width: 4, height: 3 }
  // Small ones stay crisp squares; of large ones averaging keeps thin walls in sight.
  const rendering = Math.max(width, height) < 256 ? 'pixelated' : 'auto'
  return (
    <div
      class="map-preview"
      style={{ '--aspect': Math.min(8, Math.max(1 / 8, width / height)) }}
      aria-busy={busy}
      data-testid="map-preview"
    >
      {map ? (
        <canvas
          ref={canvas}
          width={width}
          height={height}
          style={{ imageRendering: rendering }}
          role="img"
          aria-label={t('mapFile.preview')}
        />
      ) : (
        busy && <p class="hint">{t('mapFile.reading')}</p>
      )}
    </div>
  )
}

function draw(canvas: HTMLCanvasElement | null, map: Imported | null, ink: 'light' | 'dark') {
  const context = canvas?.getContext('2d')
  if (!context || !map) return
  const { width, height, resolution } = map.spec
  const heights = heightsOf(map.heights)
  const { free, blocked } = INK[ink]
  const pixels = heights
    ? hillShade(heights, width, [resolution, resolution])
    : new Uint8ClampedArray(Uint32Array.from(map.cells, (cell) => (cell ? blocked : free)).buffer)
  context.putImageData(new ImageData(pixels, width, height), 0, 0)
}
