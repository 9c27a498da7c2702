import { effect, signal } from '@preact/signals'
import { mapChoice, mapFile, notifyError, scenChoice, terrainFile, wholeEngine } from '../state'
import { closeDialog, openDialog } from '../state/dialogs'

const fetched = signal<typeof import('./all_dialogs') | null>(null)

// Fetched when one is asked for, or once the whole engine is here, so that sharing and saving outlive the connection.
effect(() => {
  const asked =
    openDialog.value || scenChoice.value || terrainFile.value || mapFile.value || mapChoice.value
  if (fetched.value || (!asked && wholeEngine.value !== 'here')) return
  import('./all_dialogs').then(
    (dialogs) => {
      fetched.value = dialogs
    },
    (error) => {
      if (!asked) return
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
  if (terrainFile.value) return <dialogs.TerrainDialog file={terrainFile.value} />
  if (mapFile.value) return <dialogs.MapDialog key={mapFile.value} file={mapFile.value} />
  if (mapChoice.value) return <dialogs.MapChoiceDialog choice={mapChoice.value} />
  const Open = openDialog.value && dialogs.DIALOGS[openDialog.value]
  return Open ? <Open /> : null
}
