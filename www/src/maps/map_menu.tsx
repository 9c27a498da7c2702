import {
  Contrast,
  Dices,
  Download,
  Eraser,
  Map as MapIcon,
  RotateCcw,
  Scaling,
  Upload,
} from 'lucide'
import { t } from '../i18n'
import { clearWalls, galleryId, invertWalls, openGallery, scenario, startOver } from '../state'
import { show } from '../ui/dialogs'
import { Icon } from '../ui/icon'
import { Menu, MenuHeading, MenuItem } from '../ui/menu'
import { gallery } from './gallery'
import { movementName } from './movement'

/** Name of the map on show: a built-in one in the reader's language, any other as it came. */
export function mapName(): string {
  const id = galleryId.value
  return id ? galleryName(id) : (scenario.value?.spec.name ?? '')
}

export function MapMenu() {
  const spec = scenario.value?.spec
  const size = spec ? `${spec.width} × ${spec.height}` : ''
  return (
    <Menu
      label={t('maps.menu')}
      testId="map-menu"
      face={
        <span class="map-face">
          <Icon icon={MapIcon} size={16} />
          <span class="map-name">{mapName()}</span>
          <span class="map-size">{size}</span>
        </span>
      }
    >
      <MenuHeading text={t('maps.gallery')} />
      {gallery.map(({ id }) => (
        <MenuItem
          key={id}
          label={galleryName(id)}
          note={galleryNote(id)}
          testId={`gallery-${id}`}
          checked={galleryId.value === id}
          onClick={() => openGallery(id)}
        />
      ))}
      <MenuItem
        icon={RotateCcw}
        label={t('maps.startOver')}
        note={t('maps.startOverNote')}
        testId="start-over"
        onClick={startOver}
      />
      <MenuHeading text={t('maps.make')} />
      <MenuItem
        icon={Dices}
        label={t('maps.generate')}
        testId="open-generate"
        onClick={() => show('generate')}
      />
      <MenuItem
        icon={Scaling}
        label={t('maps.shape')}
        note={spec ? `${size} · ${movementName(spec.movement)}` : undefined}
        testId="open-resize"
        onClick={() => show('resize')}
      />
      <MenuItem icon={Eraser} label={t('maps.clear')} testId="clear" onClick={clearWalls} />
      <MenuItem icon={Contrast} label={t('maps.invert')} testId="invert" onClick={invertWalls} />
      <MenuHeading text={t('maps.files')} />
      <MenuItem
        icon={Upload}
        label={t('maps.import')}
        testId="open-import"
        onClick={() => show('import')}
      />
      <MenuItem
        icon={Download}
        label={t('maps.export')}
        testId="open-export"
        onClick={() => show('export')}
      />
    </Menu>
  )
}

type GalleryKey = 'two-corridors'

const galleryName = (id: string) => t(`gallery.${id as GalleryKey}.name`)
const galleryNote = (id: string) => t(`gallery.${id as GalleryKey}.note`)
