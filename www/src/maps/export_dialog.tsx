import { Copy, Download } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import type { MapFormat } from '../engine/tools'
import { t } from '../i18n'
import {
  announce,
  download,
  exportExperiment,
  exportMap,
  fileStem,
  notify,
  notifyError,
} from '../state'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { closeDialog } from '../ui/dialogs'
import { Segmented } from '../ui/fields'

type Format = MapFormat | 'experiment'

const EXTENSIONS: Record<Format, string> = {
  'movingai-map': '.map',
  'movingai-scen': '.scen',
  matrix: '.txt',
  scenario: '.scenario.json',
  experiment: '.experiment.json',
}
const FORMATS = Object.keys(EXTENSIONS) as Format[]
/** A preview is for recognising the format, not for reading a large map. */
const PREVIEW_CHARACTERS = 4000

export function ExportDialog() {
  const [format, setFormat] = useState<Format>('movingai-map')
  const text = useExport(format)
  const name = fileStem() + EXTENSIONS[format]
  return (
    <Dialog
      title={t('maps.titles.export')}
      onClose={closeDialog}
      testId="export-dialog"
      wide
      actions={
        <>
          <Button
            icon={Copy}
            label={t('common.copy')}
            testId="export-copy"
            disabled={!text}
            onClick={() => copyText(text ?? '')}
          />
          <Button
            icon={Download}
            label={t('maps.download', { name })}
            tone="primary"
            testId="export-download"
            disabled={!text}
            onClick={() => download(name, text ?? '')}
          />
        </>
      }
    >
      <Segmented
        label={t('maps.format')}
        value={format}
        options={FORMATS.map((id) => ({
          value: id,
          label: t(`maps.exports.${id}.name`),
          testId: `export-${id}`,
        }))}
        onChange={setFormat}
      />
      <p class="hint">{t(`maps.exports.${format}.note`)}</p>
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
    </Dialog>
  )
}

export async function copyText(text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text)
    notify('success', t('common.copied'))
    announce(t('common.copied'))
  } catch {
    notify('warning', t('common.copyFailed'), { hint: t('common.copyFailedHint') })
  }
}

/** The text of the chosen format; null while it is being made. */
function useExport(format: Format): string | null {
  const [text, setText] = useState<string | null>(null)
  useEffect(() => {
    let current = true
    setText(null)
    const making = format === 'experiment' ? exportExperiment() : exportMap(format)
    making.then(
      (made) => current && setText(made),
      (error) => current && notifyError(error),
    )
    return () => {
      current = false
    }
  }, [format])
  return text
}
