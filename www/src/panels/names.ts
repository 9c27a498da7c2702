/** Names, notes and what a link looked at: one part of the page. */
import '../styles/names.css'
import { addNamesWords } from '../i18n/names'
import { followAwaited } from '../playback/arrival'
import type { NamesPart } from '../state/lazy_parts'
import { builtInCalled } from '../words/built_in_names'
import { markOf } from '../words/label_marks'
import { NoteStrip, showInTab } from './note_strip'
import { PanelName } from './panel_name'

/** With its words. */
export async function namesPart(): Promise<NamesPart> {
  await addNamesWords()
  showInTab()
  followAwaited()
  return { PanelName, NoteStrip, markOf, builtInCalled }
}
