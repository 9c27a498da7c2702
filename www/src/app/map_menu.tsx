import { signal } from '@preact/signals'
import {
  CircleQuestionMark,
  Contrast,
  Dices,
  Download,
  Eraser,
  Flag,
  Map as MapIcon,
  PenLine,
  RotateCcw,
  Scaling,
  Upload,
} from 'lucide'
import { type GalleryEntry, gallery } from '../gallery/gallery'
import { t } from '../i18n'
import { showGoals } from '../panels/goals_shown'
import {
  clearWalls,
  galleryId,
  invertWalls,
  notifyError,
  openGallery,
  scenario,
  startOver,
} from '../state'
import { show } from '../state/dialogs'
import { Icon } from '../ui/icon'
import { lazily } from '../ui/lazily'
import { Menu, MenuColumn, MenuHeading, MenuItem } from '../ui/menu'
import { galleryName, galleryNote, mapName } from '../words/map_names'
import { waysOfMoving } from '../words/movement_words'

/** Pictures of the maps come with the first look. */
const looked = signal(false)
const GalleryPicture = lazily(async () => (await import('./gallery_picture')).GalleryPicture)

export function MapMenu() {
  const spec = scenario.value?.spec
  const size = spec ? `${spec.width} × ${spec.height}` : ''
  return (
    <Menu
      label={t('maps.menu')}
      testId="map-menu"
      onOpen={() => {
        looked.value = true
      }}
      face={
        <span class="map-face">
          <Icon icon={MapIcon} size={16} />
          <span class="map-name">{mapName()}</span>
          <span class="map-size">{size}</span>
        </span>
      }
    >
      <MenuColumn>
        <MenuHeading text={t('maps.gallery')} />
        {galleryItems('ready')}
        <MenuItem
          icon={CircleQuestionMark}
          label={t('maps.lessons')}
          testId="open-lessons"
          onClick={() => show('lessons')}
        />
        <MenuItem
          icon={RotateCcw}
          label={t('maps.startOver')}
          note={t('maps.startOverNote')}
          testId="start-over"
          onClick={startOver}
        />
      </MenuColumn>
      <MenuColumn>
        <MenuHeading text={t('maps.terrains')} />
        {galleryItems('terrains')}
        <MenuHeading text={t('maps.papers')} />
        {galleryItems('papers')}
      </MenuColumn>
      <MenuColumn>
        <MenuHeading text={t('maps.make')} />
        <MenuItem
          icon={Dices}
          label={t('maps.generate')}
          testId="open-generate"
          onClick={() => show('generate')}
        />
        <MenuItem
          icon={Scaling}
          label={t(spec?.terrain ? 'maps.shapeTerrain' : 'maps.shape')}
          note={spec ? `${size} · ${waysOfMoving(spec)}` : undefined}
          testId="open-resize"
          onClick={() => show('resize')}
        />
        <MenuItem
          icon={Flag}
          label={t('goals.open')}
          note={t('goals.openNote')}
          testId="open-goals"
          onClick={showGoals}
        />
        <MenuItem icon={Eraser} label={t('maps.clear')} testId="clear" onClick={clearWalls} />
        <MenuItem
          icon={Contrast}
          label={t('maps.invert')}
          unavailable={spec?.terrain ? t('maps.invertTerrain') : null}
          testId="invert"
          onClick={invertWalls}
        />
        <MenuItem
          icon={PenLine}
          label={t('maps.names')}
          testId="open-names"
          onClick={() => show('names')}
        />
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
      </MenuColumn>
    </Menu>
  )
}

const galleryItems = (group: GalleryEntry['group']) =>
  gallery.filter((entry) => entry.group === group).map(galleryItem)

function galleryItem({ id }: GalleryEntry) {
  return (
    <MenuItem
      key={id}
      label={galleryName(id)}
      picture={looked.value && <GalleryPicture id={id} />}
      note={galleryNote(id)}
      testId={`gallery-${id}`}
      checked={galleryId.value === id}
      onClick={() => openGallery(id).catch(notifyError)}
    />
  )
}
