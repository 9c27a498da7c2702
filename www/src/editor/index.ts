/** Drawing with more than one cell after the other, and taking up parts of the map: one part of the page, fetched when wanted. */
import '../styles/editor.css'
import { addEditorWords } from '../i18n/editor'
import type { Press } from '../model/stroke'
import { tool } from '../state'
import type { EditorPart } from '../state/lazy_parts'
import { EditPreview } from './edit_preview'
import { handleKey, shortcut } from './keys'
import { MoreTools, openShapes, wallTool } from './more_tools'
import { selectStroke } from './select_stroke'
import { wallStroke } from './shapes'

const part: EditorPart = {
  begin: (press: Press) => (tool.peek() === 'select' ? selectStroke(press) : wallStroke(press)),
  key: handleKey,
  shortcut,
  openShapes,
  wallTool,
  MoreTools,
  EditPreview,
}

export const fetchEditor = () => addEditorWords().then(() => part)
