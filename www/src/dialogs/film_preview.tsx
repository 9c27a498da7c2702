/** The first or the last frame before anything is made, each frame as it is made, and what has come of it. */
import type { ComponentChildren, RefObject } from 'preact'
import { useEffect, useState } from 'preact/hooks'
import type { FilmSize } from '../film/settings'
import { t } from '../i18n/film'
import { Segmented } from '../ui/fields'
import type { Work } from './film_work'

interface FilmPreviewProps {
  work: Work
  size: FilmSize
  first: boolean
  canvas: RefObject<HTMLCanvasElement | null>
  isReady: boolean
  onFirst: (first: boolean) => void
  /** Beside the choice of the frame. */
  children: ComponentChildren
}

export function FilmPreview(props: FilmPreviewProps) {
  const { work, size, first, canvas, isReady, onFirst } = props
  const choosing = work.phase === 'choosing'
  const picture = usePicture(work)
  return (
    <div class="film-preview" data-testid="film-preview" data-ready={!choosing || isReady}>
      <div class="film-screen">
        <canvas
          ref={canvas}
          hidden={picture !== null}
          role="img"
          aria-label={t('film.preview')}
          width={size.width}
          height={size.height}
          data-testid="film-canvas"
        />
        {picture && <img src={picture} alt={t('film.preview')} data-testid="film-picture" />}
        {choosing && !isReady && (
          <p class="film-waits" role="status">
            {t(first ? 'common.working' : 'film.makePreview')}
          </p>
        )}
      </div>
      <div class="film-below">
        <fieldset disabled={!choosing}>
          <Segmented
            label={t('film.preview')}
            value={first ? 'first' : 'final'}
            options={(['first', 'final'] as const).map((value) => ({
              value,
              label: t(`film.${value}`),
              testId: `film-${value}`,
            }))}
            onChange={(which) => onFirst(which === 'first')}
          />
        </fieldset>
        {props.children}
      </div>
    </div>
  )
}

/** The address of a moving picture that has been made; a film's last frame is on the canvas. */
function usePicture(work: Work): string | null {
  const file = work.phase === 'ready' ? work.made.file : null
  const moving = file?.type === 'image/svg+xml' ? file : null
  const [shown, setShown] = useState<string | null>(null)
  useEffect(() => {
    if (!moving) return
    const url = URL.createObjectURL(moving)
    setShown(url)
    return () => {
      setShown(null)
      URL.revokeObjectURL(url)
    }
  }, [moving])
  return shown
}
