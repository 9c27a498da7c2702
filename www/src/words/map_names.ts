/** Names of maps in the reader's language. */
import { t } from '../i18n'
import { galleryId, scenario } from '../state'
import { names } from '../state/lazy_parts'

/** A built-in scenario: all have the same two texts, so one key stands for their type. */
type GalleryKey = 'two-corridors'

export const galleryName = (id: string) => t(`gallery.${id as GalleryKey}.name`)
export const galleryNote = (id: string) => t(`gallery.${id as GalleryKey}.note`)

/** Of the map on show: a built-in one in the reader's language, changed or not, until it is renamed; any other as it came. */
export function mapName(): string {
  const name = scenario.value?.spec.name ?? ''
  const id = galleryId.value ?? names.value?.builtInCalled(name)
  return id ? galleryName(id) : name
}
