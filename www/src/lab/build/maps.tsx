/** The maps on which every planner runs. */
import { Map as MapIcon, Plus, Upload, X } from 'lucide'
import { useEffect, useRef, useState } from 'preact/hooks'
import { gallery } from '../../gallery/gallery'
import { t } from '../../i18n/lab'
import type { DraftMap } from '../../model/draft'
import { MAP_ENDINGS } from '../../model/endings'
import { notifyError } from '../../state'
import { lazyParts } from '../../state/lazy_parts'
import { IconButton } from '../../ui/buttons'
import { useFilePicker } from '../../ui/file_picker'
import { FormError } from '../../ui/form_error'
import { Icon } from '../../ui/icon'
import { Menu, MenuColumn, MenuHeading, MenuItem } from '../../ui/menu'
import { galleryName, mapName } from '../../words/map_names'
import { addCurrentMap, addMap, maps, removeMap } from './draft'

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
      <Thumbnail map={map} />
      <span class="draft-map-words">
        <strong>{name}</strong>
        <span class="hint">{t('lab.build.size', { width, height })}</span>
      </span>
      <IconButton
        icon={X}
        label={t('lab.build.removeMap', { name })}
        tone="quiet"
        size={16}
        onClick={() => removeMap(key)}
      />
    </li>
  )
}

/** A picture of the map, one pixel a cell. */
function Thumbnail({ map: { scenario } }: { map: DraftMap }) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const { spec, cells } = scenario
  useEffect(() => {
    const context = canvas.current?.getContext('2d')
    if (!context) return
    const picture = context.createImageData(spec.width, spec.height)
    cells.forEach((cell, at) => {
      picture.data.set(cell === 1 ? [60, 78, 71, 255] : [226, 232, 229, 255], at * 4)
    })
    context.putImageData(picture, 0, 0)
    mark(context, spec.start, '#0b8f69')
    for (const { at } of spec.goals) mark(context, at, '#c8342b')
  }, [scenario])
  return (
    <span class="thumbnail" aria-hidden="true">
      <canvas ref={canvas} width={spec.width} height={spec.height} />
    </span>
  )
}

function mark(context: CanvasRenderingContext2D, [x, y]: [number, number], colour: string): void {
  const size = Math.max(1, Math.round(context.canvas.width / 16))
  context.fillStyle = colour
  context.fillRect(x - Math.floor(size / 2), y - Math.floor(size / 2), size, size)
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
