/** The maps on which every planner runs. */
import { Map as MapIcon, Plus, Upload } from 'lucide'
import { useState } from 'preact/hooks'
import { gallery } from '../../gallery/gallery'
import { t } from '../../i18n/lab'
import type { DraftMap } from '../../model/draft'
import { MAP_ENDINGS } from '../../model/endings'
import { notifyError } from '../../state'
import { lazyParts } from '../../state/lazy_parts'
import { CloseButton } from '../../ui/buttons'
import { useFilePicker } from '../../ui/file_picker'
import { FormError } from '../../ui/form_error'
import { Icon } from '../../ui/icon'
import { Menu, MenuColumn, MenuHeading, MenuItem } from '../../ui/menu'
import { galleryName, mapName } from '../../words/map_names'
import { addCurrentMap, addMap, maps, removeMap } from './draft'
import { Thumbnail } from './thumbnail'

const GROUPS = [
  ['ready', 'maps.gallery'],
  ['terrains', 'maps.terrains'],
  ['papers', 'maps.papers'],
] as const
export function Maps() {
  const [error, setError] = useState<unknown>(null)
  const open = (files: File[]) => {
    setError(null)
    openMapFiles(files).catch(setError)
  }
  const { pick, element } = useFilePicker({
    label: t('lab.build.mapFile'),
    accept: MAP_ENDINGS,
    multiple: true,
    testId: 'lab-map-file',
    onFiles: open,
  })
  return (
    <fieldset class="builder-part">
      <legend>{t('lab.build.maps')}</legend>
      <ul class="draft-maps">
        {maps.value.map((map) => (
          <MapItem key={map.key} map={map} />
        ))}
        <li>
          <AddMap pick={pick} />
        </li>
      </ul>
      {maps.value.length === 0 && <p class="hint">{t('lab.build.noMaps')}</p>}
      {error !== null && <FormError error={error} />}
      {element}
    </fieldset>
  )
}

function MapItem({ map }: { map: DraftMap }) {
  const { key, name, scenario } = map
  const { width, height } = scenario.spec
  return (
    <li class="draft-map" data-testid="draft-map">
      <Thumbnail scenario={scenario} />
      <span class="draft-map-words">
        <strong>{name}</strong>
        <span class="hint">{t('lab.build.size', { width, height })}</span>
      </span>
      <CloseButton label={t('lab.build.removeMap', { name })} onClick={() => removeMap(key)} />
    </li>
  )
}

function AddMap({ pick }: { pick: () => void }) {
  return (
    <Menu
      label={t('lab.build.addMap')}
      testId="lab-add-map"
      face={
        <span class="menu-face">
          <Icon icon={Plus} size={16} />
          <span>{t('lab.build.addMap')}</span>
        </span>
      }
    >
      <MenuColumn>
        <MenuItem
          icon={MapIcon}
          label={t('lab.build.currentMap')}
          note={mapName()}
          testId="add-current-map"
          onClick={addCurrentMap}
        />
        <MenuItem
          icon={Upload}
          label={t('lab.build.mapFile')}
          note={t('lab.build.mapFileHint')}
          testId="add-map-file"
          onClick={pick}
        />
        <Group at={0} />
      </MenuColumn>
      <MenuColumn>
        <Group at={1} />
        <Group at={2} />
      </MenuColumn>
    </Menu>
  )
}

function Group({ at }: { at: 0 | 1 | 2 }) {
  const [group, heading] = GROUPS[at]
  return (
    <>
      <MenuHeading text={t(heading)} />
      {gallery
        .filter((entry) => entry.group === group)
        .map(({ id, scenario }) => (
          <MenuItem
            key={id}
            label={galleryName(id)}
            testId={`add-map-${id}`}
            onClick={() => {
              scenario().then((opened) => addMap(galleryName(id), opened), notifyError)
            }}
          />
        ))}
    </>
  )
}

/** What leaves a choice is looked at first, as in the race. */
async function openMapFiles(files: File[]): Promise<void> {
  const { openMapsFor } = await lazyParts.opener()
  await openMapsFor(files, (opened) => addMap(opened.spec.name, opened))
}
