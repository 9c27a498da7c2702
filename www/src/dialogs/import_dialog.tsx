import { useId, useState } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { MAP_ENDINGS } from '../model/endings'
import { openFiles, openText } from '../state'
import { closeDialog, openDialog } from '../state/dialogs'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { useFilePicker } from '../ui/file_picker'
import { FormError } from '../ui/form_error'

const FORMATS = [
  'map',
  'scen',
  'matrix',
  'drawing',
  'picture',
  'ros',
  'raster',
  'path',
  'order',
  'json',
  'archive',
  'link',
] as const
/** What the file picker offers first. */
const ENDINGS = `${MAP_ENDINGS},.scen,.tsp,.atsp,.tour,.geojson,.svg`

export function ImportDialog() {
  const [text, setText] = useState('')
  const textId = useId()
  const [error, setError] = useState<unknown>(null)
  // What was opened may have a dialog of its own.
  const close = () => openDialog.peek() === 'import' && closeDialog()
  const settle = (opening: Promise<boolean>) => opening.then(close, setError)
  const { pick, element } = useFilePicker({
    label: t('maps.chooseFiles'),
    accept: ENDINGS,
    multiple: true,
    testId: 'import-file',
    onFiles: (files) => settle(openFiles(files)),
  })
  return (
    <Dialog
      title={t('maps.titles.import')}
      onClose={closeDialog}
      testId="import-dialog"
      actions={
        <Button
          label={t('maps.importText')}
          tone="primary"
          testId="import-text"
          disabled={text.trim() === ''}
          onClick={() => settle(openText(text))}
        />
      }
    >
      {element}
      <button type="button" class="drop-target" onClick={pick}>
        <strong>{t('maps.chooseFiles')}</strong>
        <span class="hint">{t('maps.orDrop')}</span>
      </button>
      <label class="field-label" for={textId}>
        {t('maps.pasteHere')}
      </label>
      <textarea
        id={textId}
        class="input text-area"
        rows={6}
        spellcheck={false}
        placeholder={'0 0 0 1 0\n0 1 0 1 0\n0 1 0 0 0'}
        data-testid="import-area"
        value={text}
        onInput={(event) => setText(event.currentTarget.value)}
      />
      {error !== null && <FormError error={error} />}
      <ul class="formats">
        {FORMATS.map((id) => (
          <li key={id}>{t(`maps.formats.${id}`)}</li>
        ))}
      </ul>
    </Dialog>
  )
}
