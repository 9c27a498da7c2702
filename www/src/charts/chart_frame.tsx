/** What charts have in common around their plot: an element that keys can use, and the way back from a zoom. */
import type { ReadonlySignal } from '@preact/signals'
import { Image, Maximize } from 'lucide'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../i18n/reading'
import { type PictureKind, takePicture } from '../state/pictures'
import { IconButton } from '../ui/buttons'
import type { ChartCursor } from './chart_cursor'

interface ChartFrameProps {
  testId: string
  /** What it is taken away as. */
  picture: PictureKind
  cursor: ChartCursor
  label: ReadonlySignal<string>
  /** The axis, and where on it the cursor is; as numbers and in words. */
  ends: [number, number]
  at: number
  words: string
  /** Draws into the element until it is stopped. */
  keepDrawn: (host: HTMLElement) => () => void
}

export function ChartFrame(props: ChartFrameProps) {
  const { testId, picture, cursor, label, ends, at, words, keepDrawn } = props
  const host = useRef<HTMLDivElement>(null)
  useEffect(() => (host.current ? keepDrawn(host.current) : undefined), [])
  return (
    <div class="plot" data-empty={false}>
      <div
        ref={host}
        class="plot-host"
        role="slider"
        tabIndex={0}
        aria-label={label}
        aria-valuemin={ends[0]}
        aria-valuemax={ends[1]}
        aria-valuenow={at}
        aria-valuetext={words}
        data-testid={testId}
        onKeyDown={cursor.onKey}
      />
      <span class="plot-tools">
        {cursor.zoom.value && (
          <IconButton
            icon={Maximize}
            label={t('cursor.reset')}
            keys="Esc"
            tone="quiet"
            size={16}
            testId={`${testId}-reset`}
            onClick={() => cursor.reset()}
          />
        )}
        <IconButton
          icon={Image}
          label={t('cursor.picture')}
          tone="quiet"
          size={16}
          testId={`${testId}-picture`}
          onClick={() => takePicture(picture)}
        />
      </span>
    </div>
  )
}
