import { useEffect, useState } from 'preact/hooks'
import { addNamesWords, t } from '../i18n/names'
import { notifyError } from '../state'
import { closeDialog } from '../state/dialogs'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { NamesFields } from './names_fields'

/** What the race and its map are called, and what is said of them. */
export function NamesDialog() {
  const ready = useNamesWords()
  if (!ready) return null
  return (
    <Dialog
      title={t('names.dialog')}
      onClose={closeDialog}
      testId="names-dialog"
      actions={
        <Button label={t('names.done')} tone="primary" testId="names-done" onClick={closeDialog} />
      }
    >
      <p>{t('names.about')}</p>
      <NamesFields />
    </Dialog>
  )
}

/** Whether the words of names are here. */
export function useNamesWords(): boolean {
  const [ready, setReady] = useState(false)
  useEffect(() => {
    addNamesWords().then(() => setReady(true), notifyError)
  }, [])
  return ready
}
