import { effect, signal } from '@preact/signals'
import { notifyError, scenChoice } from '../state'
import { closeDialog, openDialog } from './dialogs'

const fetched = signal<typeof import('./all_dialogs') | null>(null)

effect(() => {
  if (fetched.value || (!openDialog.value && !scenChoice.value)) return
  import('./all_dialogs').then(
    (dialogs) => {
      fetched.value = dialogs
    },
    (error) => {
      closeDialog()
      notifyError(error)
    },
  )
})

/** The dialog that is open, if any. */
export function Dialogs() {
  const dialogs = fetched.value
  if (!dialogs) return null
  if (scenChoice.value) return <dialogs.ScenDialog choice={scenChoice.value} />
  const Open = openDialog.value && dialogs.DIALOGS[openDialog.value]
  return Open ? <Open /> : null
}
