/** Several maps came together: which of them is to be opened? */
import { useState } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { type FoundFile, type MapChoice, mapChoice } from '../state'
import { openChosen } from '../state/open_files'
import { Dialog } from '../ui/dialog'
import { FormError } from '../ui/form_error'
import { kindName } from './kind_words'

export function MapChoiceDialog({ choice }: { choice: MapChoice }) {
  const [error, setError] = useState<unknown>(null)
  const close = () => {
    mapChoice.value = null
  }
  const open = (file: FoundFile) => {
    setError(null)
    openChosen(choice, file).catch(setError)
  }
  return (
    <Dialog title={t('mapChoice.title')} onClose={close} testId="map-choice-dialog">
      <p class="hint">{t('mapChoice.hint', { count: choice.files.length })}</p>
      {error !== null && <FormError error={error} />}
      <ul class="map-files">
        {choice.files.map((file) => (
          <li key={file.name}>
            <button
              type="button"
              class="map-file"
              data-testid="map-file"
              onClick={() => open(file)}
            >
              <strong>{file.name}</strong>
              <span class="hint">{kindName(file.kind)}</span>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  )
}
