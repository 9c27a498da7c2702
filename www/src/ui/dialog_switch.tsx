import { HelpDialog } from '../help/help_dialog'
import { ExportDialog } from '../maps/export_dialog'
import { GenerateDialog } from '../maps/generate_dialog'
import { ImportDialog } from '../maps/import_dialog'
import { ResizeDialog } from '../maps/resize_dialog'
import { ScenDialog } from '../maps/scen_dialog'
import { ShareDialog } from '../share/share_dialog'
import { scenChoice } from '../state'
import { type DialogName, openDialog } from './dialogs'

const DIALOGS: Record<DialogName, () => preact.JSX.Element | null> = {
  share: ShareDialog,
  import: ImportDialog,
  export: ExportDialog,
  generate: GenerateDialog,
  resize: ResizeDialog,
  help: HelpDialog,
}

export function Dialogs() {
  if (scenChoice.value) return <ScenDialog choice={scenChoice.value} />
  const Open = openDialog.value && DIALOGS[openDialog.value]
  return Open ? <Open /> : null
}
