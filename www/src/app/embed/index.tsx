/** The page within another one (`?embed`), as one lazy part: fewer controls, nothing kept, and answers to the page around it. */
import '../../styles/embed.css'
import { render } from 'preact'
import { addEmbedWords, t } from '../../i18n/embed'
import { listed } from '../../i18n/lists'
import { type Control, readEmbedding } from '../../model/embedding'
import { engineVersion, notify, scenario, startPage, tool } from '../../state'
import { mapIsFixed } from '../../state/embedding'
import { view } from '../../state/page_view'
import { listenForDrops } from '../drop_files'
import { listenForPaste } from '../paste'
import { listenForKeys } from '../shortcuts'
import { Embedded } from './embedded'
import { tellEvents } from './events'
import { answerParent } from './messages'

/** The page's keys that come with a control; on a map, arrows and magnifying are always there. */
const KEYS: Record<Control, readonly string[]> = {
  play: [' ', 'r', 'Home', ',', '.'],
  step: ['ArrowRight', 'Shift+ArrowRight', ']'],
  numbers: [],
  layers: ['0', '3'],
  edit: [...'wesgahlbndmjk', 'Ctrl+z', 'Ctrl+Shift+z', 'Ctrl+y', 'Escape'],
  charts: [],
  open: [],
}

export async function startEmbedded(query: URLSearchParams): Promise<void> {
  await addEmbedWords()
  const { controls, origin, unclear } = readEmbedding(query)
  const keys = new Set([...controls].flatMap((control) => KEYS[control]))
  listenForKeys((name) => keys.has(name))
  if (controls.has('open')) {
    listenForPaste()
    listenForDrops()
  }
  if (!controls.has('edit')) {
    mapIsFixed.value = true
    tool.value = 'pan'
  }
  const started = startPage()
  const parent = answerParent(origin, started)
  const root = document.getElementById('app')
  if (root) render(<Embedded controls={controls} started={started} />, root)
  for (const { what, known } of unclear)
    notify('warning', t('embed.unclear', { what }), {
      hint: t('embed.unclearHint', { known: listed([...known]) }),
      stays: true,
    })
  await started
  const opened = scenario.peek() !== null || view.peek() === 'lab'
  parent.tell('ready', { version: engineVersion.peek(), opened })
  tellEvents(parent)
}
