/** Every dialog, in one part of the page that is fetched when the first of them is opened. */
import type { JSX } from 'preact'
import { HelpDialog } from '../help/help_dialog'
import { ExportDialog } from '../maps/export_dialog'
import { GenerateDialog } from '../maps/generate_dialog'
import { ImportDialog } from '../maps/import_dialog'
import { ResizeDialog } from '../maps/resize_dialog'
import { ScenDialog } from '../maps/scen_dialog'
import { TerrainDialog } from '../maps/terrain_dialog'
import { CardDialog } from '../papers/card_dialog'
import { ShareDialog } from '../share/share_dialog'
import type { DialogName } from './dialogs'

export const DIALOGS: Record<DialogName, () => JSX.Element | null> = {
  share: ShareDialog,
  import: ImportDialog,
  export: ExportDialog,
  generate: GenerateDialog,
  resize: ResizeDialog,
  help: HelpDialog,
  paper: CardDialog,
}

export { ScenDialog, TerrainDialog }
