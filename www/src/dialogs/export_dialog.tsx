import type { ExportFormat } from '@pkg/formicarium'
import { Copy, Download, Image } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { notifyError, scenario } from '../state'
import { closeDialog } from '../state/dialogs'
import {
  download,
  exportGeotiff,
  exportMap,
  exportRos,
  exportSession,
  fileStem,
} from '../state/export_files'
import { takePicture } from '../state/pictures'
import { Button } from '../ui/buttons'
import { copyText } from '../ui/copy_text'
import { Dialog } from '../ui/dialog'
import { Segmented } from '../ui/fields'
import { lazily } from '../ui/lazily'

const PathOffer = lazily(async () => (await import('./path_offer')).fetchPathOffer())

/** `experiment` is a session: the file's ending has kept its former name. */
type Format = ExportFormat | 'geotiff' | 'ros' | 'experiment'

const EXTENSIONS: Record<Format, string> = {
  'movingai-map': '.map',
  'movingai-scen': '.scen',
  matrix: '.txt',
  'esri-ascii': '.asc',
  'height-table': '.csv',
  geotiff: '.tif',
  ros: '.yaml',
  scenario: '.scenario.json',
  experiment: '.experiment.json',
}
/** For maps without heights, the likeliest first. */
const PLANAR: Format[] = [
  'movingai-map',
  'movingai-scen',
  'matrix',
  'ros',
  'scenario',
  'experiment',
]
/** For terrains, those that keep the heights first. */
const OF_TERRAINS: Format[] = [
  'esri-ascii',
  'height-table',
  'geotiff',
  'scenario',
  'experiment',
  'movingai-map',
  'movingai-scen',
  'matrix',
  'ros',
]
/** Formats without heights. */
const FLATTENING: Format[] = ['movingai-map', 'movingai-scen', 'matrix', 'ros']
const TYPES: Partial<Record<Format, string>> = {
  geotiff: 'image/tiff',
  'height-table': 'text/csv',
  ros: 'application/yaml',
}
/** A preview is for recognising the format, not for reading a large map. */
const PREVIEW_CHARACTERS = 4000

export function ExportDialog() {
  const onTerrain = scenario.value?.heights != null
  const formats = onTerrain ? OF_TERRAINS : PLANAR
  const [format, setFormat] = useState<Format>(formats[0] ?? 'scenario')
  const made = useExport(format)
  const content = made?.content ?? null
  const text = typeof content === 'string' ? content : null
  const name = fileStem() + EXTENSIONS[format]
  const other = `${fileStem()}.pgm`
  const save = () => {
    download(name, content ?? '', TYPES[format])
    if (made?.picture) download(other, made.picture, 'image/x-portable-graymap')
  }
  return (
    <Dialog
      title={t('maps.titles.export')}
      onClose={closeDialog}
      testId="export-dialog"
      wide
      actions={
        <>
          <Button
            icon={Image}
            label={t('maps.asPicture')}
            tone="quiet"
            testId="export-picture"
            onClick={() => takePicture('map')}
          />
          <Button
            icon={Copy}
            label={t('common.copy')}
            testId="export-copy"
            disabled={!text}
            onClick={() => copyText(text ?? '')}
          />
          <Button
            icon={Download}
            label={t(format === 'ros' ? 'maps.downloadBoth' : 'maps.download', { name, other })}
            tone="primary"
            testId="export-download"
            disabled={!content?.length}
            onClick={save}
          />
        </>
      }
    >
      <Segmented
        label={t('maps.format')}
        value={format}
        options={formats.map((id) => ({
          value: id,
          label: t(`maps.exports.${id}.name`),
          testId: `export-${id}`,
        }))}
        onChange={setFormat}
      />
      <p class="hint">{t(`maps.exports.${format}.note`)}</p>
      {onTerrain && FLATTENING.includes(format) && (
        <p class="banner" data-testid="export-flattens">
          {t('maps.exportFlattens')}
        </p>
      )}
      {content instanceof Uint8Array ? (
        <p class="hint" data-testid="export-bytes">
          {t('maps.exportBinary', { bytes: numbers.value.whole.format(content.length) })}
        </p>
      ) : (
        <textarea
          class="input preview"
          readOnly
          rows={14}
          wrap="off"
          spellcheck={false}
          aria-label={t('maps.preview')}
          data-testid="export-preview"
          value={text === null ? t('common.working') : text.slice(0, PREVIEW_CHARACTERS)}
        />
      )}
      <PathOffer />
    </Dialog>
  )
}

/** A file, and the picture that goes with the description of a ROS map. */
interface Made {
  content: string | Uint8Array
  picture?: Uint8Array
}

/** The file in the chosen format; null while it is being made, even if one in another format is there. */
function useExport(format: Format): Made | null {
  const [made, setMade] = useState<(Made & { format: Format }) | null>(null)
  useEffect(() => {
    let current = true
    make(format).then(
      (file) => current && setMade({ format, ...file }),
      (error) => current && notifyError(error),
    )
    return () => {
      current = false
    }
  }, [format])
  return made?.format === format ? made : null
}

async function make(format: Format): Promise<Made> {
  if (format === 'experiment') return { content: await exportSession() }
  if (format === 'geotiff') return { content: await exportGeotiff() }
  if (format !== 'ros') return { content: await exportMap(format) }
  const files = await exportRos()
  return { content: files?.yaml ?? '', picture: files?.pgm }
}
