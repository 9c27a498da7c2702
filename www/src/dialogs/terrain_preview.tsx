/** A picture of a raster on which a part can be marked by dragging. The numbers beside it say the same, for the keyboard. */
import type { Survey } from '@pkg/formicarium'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { numbersOf } from '../model/cell_numbers'
import { hillShade } from '../model/hill_shade'
import { type Crop, cropBetween, isWhole } from '../model/raster_part'

interface PreviewProps {
  survey: Survey
  crop: Crop
  onCrop: (crop: Crop) => void
}

export function TerrainPreview({ survey, crop, onCrop }: PreviewProps) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const from = useRef<[number, number] | null>(null)
  useEffect(() => draw(canvas.current, survey), [survey])
  const { width, height, cell } = survey
  const share = (event: PointerEvent): [number, number] => {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect()
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height]
  }
  const percent = (part: number, whole: number) => `${(100 * part) / whole}%`
  return (
    <div
      class="raster-preview"
      style={{ '--aspect': (width * cell[0]) / (height * cell[1]) }}
      data-testid="raster-preview"
      onPointerDown={(event) => {
        if (event.button !== 0) return
        event.preventDefault()
        event.currentTarget.setPointerCapture(event.pointerId)
        from.current = share(event)
      }}
      onPointerMove={(event) => {
        if (from.current) onCrop(cropBetween(from.current, share(event), survey))
      }}
      onPointerUp={() => {
        from.current = null
      }}
      onPointerCancel={() => {
        from.current = null
      }}
    >
      <canvas
        ref={canvas}
        width={survey.preview_width}
        height={survey.preview_height}
        role="img"
        aria-label={t('raster.preview')}
      />
      {!isWhole(crop, survey) && (
        <div
          class="raster-crop"
          data-testid="raster-crop"
          style={{
            left: percent(crop.x, width),
            top: percent(crop.y, height),
            width: percent(crop.width, width),
            height: percent(crop.height, height),
          }}
        />
      )}
    </div>
  )
}

function draw(canvas: HTMLCanvasElement | null, survey: Survey): void {
  const { preview, preview_width, preview_height, width, height, cell } = survey
  const heights = numbersOf(preview)
  const context = canvas?.getContext('2d')
  if (!context || !heights) return
  const metres = [(width * cell[0]) / preview_width, (height * cell[1]) / preview_height] as const
  const pixels = hillShade(heights, preview_width, metres)
  context.putImageData(new ImageData(pixels, preview_width, preview_height), 0, 0)
}
