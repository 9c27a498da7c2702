/** Shows what a file that leaves a choice would come to, before anything on the page is replaced. */
import type { Imported } from '@pkg/formicarium'
import { useEffect, useMemo, useState } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { describeNotice } from '../i18n/errors'
import { mapToShow } from '../model/map_pixels'
import { WATCHED_SIDE } from '../model/raster_part'
import { type MapFile, mapFile } from '../state'
import { bytesOf } from '../state/file_bytes'
import { sameName } from '../state/file_paths'
import { openMap } from '../state/open_files'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { useFilePicker } from '../ui/file_picker'
import { FormError } from '../ui/form_error'
import { FigureBody, WhyNotYet } from './figure_body'
import { type FigureState, useFigure } from './figure_state'
import { kindName, whyWords } from './kind_words'
import {
  choicesFit,
  isPicture,
  isRobots,
  longest,
  type MapChoices,
  optionsOf,
  type Sides,
  USUAL,
} from './map_choices'
import { MatrixField, PictureFields, RobotFields, SwampFields } from './map_fields'
import { MapPreview } from './map_preview'
import { readPart, useReading } from './map_reading'
import { type ReadAs, ReadAsField } from './read_as_field'

export function MapDialog({ file }: { file: MapFile }) {
  return file.needs === null ? <Reading file={file} /> : <MissingPicture file={file} />
}

const close = () => {
  mapFile.value = null
}

function Reading({ file }: { file: MapFile }) {
  const [choices, setChoices] = useState<MapChoices>(USUAL)
  const [whole, setWhole] = useState<Sides | null>(null)
  const [opening, setOpening] = useState(false)
  const [refused, setRefused] = useState<unknown>(null)
  const change = (changed: Partial<MapChoices>) => {
    setRefused(null)
    setChoices((before) => ({ ...before, ...changed }))
  }
  const fits = choicesFit(choices, whole)
  const fit = fits.crop && fits.cells && fits.metres
  const options = optionsOf(file, choices)
  const { answer: map, settled, error } = useReading(file, fit ? options : null, choices.knownOnly)
  const shown = useMemo(() => map && mapToShow(map), [map])
  const [as, setAs] = useState<ReadAs>('picture')
  const asFigure = as === 'figure'
  const figure = useFigure(file, asFigure, whole !== null && isPicture(file) && isSoonLooked(whole))

  // The first reading tells how large it is; more cells than can be watched are not proposed.
  useEffect(() => {
    if (!map || whole) return
    const size = sizeBefore(map)
    setWhole(size)
    if (isPicture(file) && longest(size) > WATCHED_SIDE) change({ cells: WATCHED_SIDE })
  }, [map])

  const open = async () => {
    if (
      opening ||
      !(asFigure ? figure.classes && figure.isPlaced : fit && !(settled && error !== null))
    )
      return
    setOpening(true)
    try {
      const read = asFigure
        ? figure.take()
        : settled && map
          ? map
          : readPart(file, options, choices.knownOnly)
      await openMap(file, options, await read)
    } catch (thrown) {
      setRefused(thrown)
      setOpening(false)
    }
  }
  const wrong = refused ?? error
  // Of a map that is still being read the former size would be another one's.
  const size = asFigure ? figureSize(figure) : settled ? map?.spec : undefined
  return (
    <Dialog
      title={t('raster.title', { name: file.name })}
      onClose={close}
      onEnter={open}
      testId="map-dialog"
      wide
      actions={
        <>
          {asFigure && <WhyNotYet figure={figure} />}
          <Button label={t('mapFile.cancel')} testId="map-cancel" onClick={close} />
          <span class="map-open">
            <Button
              label={size ? t('raster.open', shownSize(size)) : t('maps.importText')}
              tone="primary"
              testId="map-open"
              disabled={
                asFigure
                  ? !figure.isPlaced || figure.classes === null
                  : !fit || map === null || error !== null
              }
              busy={opening}
              onClick={open}
            />
          </span>
        </>
      }
    >
      {isPicture(file) && (
        <ReadAsField
          as={as}
          figure={figure}
          onChange={(chosen) => {
            setRefused(null)
            setAs(chosen)
          }}
        />
      )}
      {asFigure && <FigureBody figure={figure} />}
      {asFigure && refused !== null && <FormError error={refused} />}
      {!asFigure && (
        <>
          <OtherPicture file={file} />
          <div class="raster">
            <MapPreview map={shown} busy={!settled && fit} />
            <Facts file={file} map={map} />
          </div>
          {wrong !== null && <FormError error={wrong} />}
          {file.matrices.length > 1 && (
            <MatrixField
              matrices={file.matrices}
              chosen={choices.matrix}
              onChange={(matrix) => change({ matrix })}
            />
          )}
          {isPicture(file) && (
            <PictureFields
              choices={choices}
              fits={fits}
              whole={whole}
              used={thresholdOf(map)}
              onChange={change}
            />
          )}
          {isRobots(file) && (
            <RobotFields choices={choices} fits={fits} whole={whole} onChange={change} />
          )}
          {file.swamp && <SwampFields choices={choices} onChange={change} />}
          {wrong === null && map && <Notices file={file} map={map} />}
        </>
      )}
    </Dialog>
  )
}

function Facts({ file, map }: { file: MapFile; map: Imported | null }) {
  const why = t('mapFile.toldBy', { why: whyWords(file.why) })
  const rows: [string, string, string, string?][] = [
    ['kind', t('mapFile.readAs'), kindName(map?.kind ?? file.kind), why],
  ]
  if (map) {
    const { width, height, resolution } = map.spec
    const blocked = map.cells.reduce((sum, cell) => sum + cell, 0)
    const all = map.cells.length
    rows.push(
      [
        'size',
        t('raster.size'),
        `${whole(width)} × ${whole(height)}`,
        isPicture(file) || isRobots(file)
          ? t('raster.metres', { x: fine(width * resolution), y: fine(height * resolution) })
          : undefined,
      ],
      ['free', t('mapFile.free'), counted(all - blocked, all)],
      ['blocked', t('mapFile.blocked'), counted(blocked, all)],
    )
  }
  return (
    <dl class="raster-facts map-facts" aria-live="polite">
      {rows.map(([id, label, value, note]) => (
        <div key={id}>
          <dt>{label}</dt>
          <dd data-testid={`map-${id}`}>
            {value}
            {note && <span class="hint">{note}</span>}
          </dd>
        </div>
      ))}
    </dl>
  )
}

/** A ROS map with a picture that its description calls otherwise. */
function OtherPicture({ file: { image, names } }: { file: MapFile }) {
  if (!image || sameName(image.name, names)) return null
  return (
    <p class="remark" role="status" data-testid="map-other-picture">
      {t('mapFile.otherPicture', { image: image.name, names })}
    </p>
  )
}

/** Everything the engine says of the file, but for what stands above. */
function Notices({ file, map }: { file: MapFile; map: Imported }) {
  const told = map.warnings.filter(
    ({ kind }) =>
      kind !== 'read-as' &&
      kind !== 'picture-threshold-chosen' &&
      !(kind === 'ends-chosen' && file.scens.length > 0),
  )
  const isBare = file.bytes[0] === 137 && file.bytes[1] === 80 && isPicture(file)
  return (
    <ul class="map-notices" data-testid="map-notices">
      {told.map((notice) => (
        <li key={notice.kind}>{describeNotice(notice)}</li>
      ))}
      {isBare && <li>{t('mapFile.bare')}</li>}
    </ul>
  )
}

/** The description of a ROS map without the picture that it names. */
function MissingPicture({ file }: { file: MapFile }) {
  const [error, setError] = useState<unknown>(null)
  const needs = file.needs ?? ''
  const { pick, element } = useFilePicker({
    label: t('mapFile.choosePicture', { needs }),
    accept: '.pgm,.png,.bmp,.jpg,.jpeg',
    testId: 'map-picture',
    onFiles: ([chosen]) => {
      if (!chosen) return
      setError(null)
      bytesOf(chosen).then((bytes) => {
        mapFile.value = { ...file, image: { name: chosen.name, bytes }, needs: null }
      }, setError)
    },
  })
  return (
    <Dialog
      title={t('raster.title', { name: file.name })}
      onClose={close}
      onEnter={pick}
      testId="map-dialog"
      actions={
        <>
          <Button label={t('mapFile.cancel')} testId="map-cancel" onClick={close} />
          <Button
            label={t('mapFile.choosePicture', { needs })}
            tone="primary"
            testId="map-choose-picture"
            onClick={pick}
          />
        </>
      }
    >
      {element}
      <p data-testid="map-needs">{t('mapFile.needs', { name: file.name, needs })}</p>
      <p class="hint">{t('mapFile.needsHint')}</p>
      {error !== null && <FormError error={error} />}
    </Dialog>
  )
}

/** Columns and rows before any were put together. */
function sizeBefore({ spec, warnings }: Imported): Sides {
  const args = warnings.find(
    ({ kind }) => kind === 'picture-shrunk' || kind === 'cells-shrunk',
  )?.args
  const { width, height } = args ?? {}
  return width && height
    ? { width: Number(width), height: Number(height) }
    : { width: spec.width, height: spec.height }
}

/** The threshold that was used, as the engine tells it. */
function thresholdOf(map: Imported | null): number | null {
  const told = map?.warnings.find(({ kind }) => kind.startsWith('picture-threshold'))
  return told?.args?.threshold ? Number(told.args.threshold) : null
}

const whole = (value: number) => numbers.value.whole.format(value)
const fine = (value: number) => numbers.value.metres.format(value)
const share = (value: number) => numbers.value.share.format(value)
const counted = (some: number, all: number) => `${whole(some)} · ${share(some / all)}`
const figureSize = ({ classes, draft }: FigureState): Sides | undefined =>
  classes && draft ? { width: draft.lattice.columns, height: draft.lattice.rows } : undefined
/** Whether a lattice can be looked for unasked: in no more pixels than a moment is enough for. */
const isSoonLooked = ({ width, height }: Sides) => width * height <= 4_000_000
const shownSize = ({ width, height }: Sides) => ({ width: whole(width), height: whole(height) })
