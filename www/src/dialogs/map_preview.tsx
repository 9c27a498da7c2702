/** A map before it is opened. */
import { t } from '../i18n/dialogs'
import type { MapToShow } from '../model/map_pixels'
import { MapPicture } from './map_picture'

interface PreviewProps {
  map: MapToShow | null
  /** It is about to change. */
  busy: boolean
  /** Whether start and goals are shown. */
  ends?: boolean
}

export function MapPreview({ map, busy, ends }: PreviewProps) {
  const { width, height } = map?.spec ?? { width: 4, height: 3 }
  return (
    <div
      class="map-preview"
      style={{ '--aspect': Math.min(8, Math.max(1 / 8, width / height)) }}
      aria-busy={busy}
      data-testid="map-preview"
    >
      {map ? (
        <MapPicture map={map} label={t('mapFile.preview')} ends={ends} />
      ) : (
        busy && <p class="hint">{t('mapFile.reading')}</p>
      )}
    </div>
  )
}
