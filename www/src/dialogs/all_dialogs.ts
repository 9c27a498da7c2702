/** Every dialog, in one part of the page that is fetched when the first of them is opened. */
import type { ComponentType } from 'preact'
import '../styles/raster.css'
import '../styles/figure.css'
import '../styles/names.css'
import type { DialogName } from '../state/dialogs'
import { AboutDialog } from './about_dialog'
import { CardDialog } from './card_dialog'
import { ExportDialog } from './export_dialog'
import { FilmDialog } from './film_dialog'
import { GenerateDialog } from './generate_dialog'
import { HelpDialog } from './help_dialog'
import { ImportDialog } from './import_dialog'
import { LessonsDialog } from './lessons'
import { MapChoiceDialog } from './map_choice_dialog'
import { MapDialog } from './map_dialog'
import { NamesDialog } from './names_dialog'
import { OrderDialog } from './order_dialog'
import { PictureDialog } from './picture_dialog'
import { ResizeDialog } from './resize_dialog'
import { ScenDialog } from './scen_dialog'
import { ShareDialog } from './share_dialog'
import { TerrainDialog } from './terrain_dialog'

export const DIALOGS: Record<DialogName, ComponentType> = {
  share: ShareDialog,
  import: ImportDialog,
  export: ExportDialog,
  generate: GenerateDialog,
  resize: ResizeDialog,
  help: HelpDialog,
  lessons: LessonsDialog,
  paper: CardDialog,
  order: OrderDialog,
  names: NamesDialog,
  picture: PictureDialog,
  film: FilmDialog,
  about: AboutDialog,
}

export { fetchStrip } from './received_strip'
export { MapChoiceDialog, MapDialog, ScenDialog, TerrainDialog }
