/** The page's keys. A focused map or form control keeps the keys it uses itself. */

import {
  leaveFocus,
  notifyError,
  redo,
  reset,
  runToEnd,
  stepIteration,
  stepMove,
  toggle,
  toggleColumn,
  toggleFocus,
  tool,
  undo,
  view,
  withEditor,
} from '../state'
import { openDialog, show } from '../state/dialogs'
import { fitWholeMap, toggleRelief } from '../state/relief'

const choose = (id: typeof tool.value) => () => {
  tool.value = id
}

/** Looking back is fetched with the first look. */
const lookBy = (iterations: number) =>
  void import('../playback/look_back').then((look) => look.lookBy(iterations), notifyError)

const KEYS: Record<string, () => void> = {
  ' ': toggle,
  ArrowRight: stepMove,
  'Shift+ArrowRight': stepIteration,
  ']': stepIteration,
  ',': () => lookBy(-1),
  '.': () => lookBy(1),
  r: reset,
  Home: reset,
  End: runToEnd,
  w: choose('wall'),
  e: choose('erase'),
  s: choose('start'),
  g: choose('goal'),
  a: choose('add-goal'),
  i: choose('inspect'),
  h: choose('pan'),
  '0': fitWholeMap,
  '3': toggleRelief,
  '?': () => show('help'),
  'Ctrl+z': undo,
  'Ctrl+Shift+z': redo,
  'Ctrl+y': redo,
  f: toggleFocus,
  c: toggleColumn,
  Escape: () => {
    if (!leaveFocus()) tool.value = 'wall'
  },
}

for (const key of 'lbndumjk') KEYS[key] = () => withEditor((editor) => editor.shortcut(key))

/** `may` says which of them count. */
export function listenForKeys(may: (name: string) => boolean = () => true): void {
  noteHowFocusMoves()
  let swallowed: string | null = null
  addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.altKey || openDialog.value !== null) return
    if (keptByControl(event)) return
    const name = nameOf(event)
    const counts = (view.value === 'race' || name === '?') && may(name)
    const action = counts ? KEYS[name] : undefined
    if (!action) return
    event.preventDefault()
    action()
    swallowed = event.key
  })
  // Some browsers press a focused button when Space comes up again.
  addEventListener('keyup', (event) => {
    if (event.key === swallowed) event.preventDefault()
    swallowed = null
  })
}

/** Letters regardless of Caps Lock. Signs such as ? need Shift on many keyboards, so Shift is not part of their name. */
function nameOf({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): string {
  const command = ctrlKey || metaKey ? 'Ctrl+' : ''
  if (key.length > 1) return `${command}${shiftKey ? 'Shift+' : ''}${key}`
  return command + (command && shiftKey ? 'Shift+' : '') + key.toLowerCase()
}

function keptByControl({ target, key, ctrlKey, metaKey }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false
  if (target.closest('[role="menu"], dialog')) return true
  if (
    target.matches('textarea, select, input:not([type="range"], [type="checkbox"], [type="radio"])')
  )
    return true
  if (ctrlKey || metaKey) return false
  if (target.matches('input[type="range"]')) return /^(Arrow|Home|End|Page)/.test(key)
  if (target.matches('input[type="radio"]') && key.startsWith('Arrow')) return true
  return key === ' ' && target.matches('button, input') && reachedByTab.has(target)
}

/**
 * Space presses a control that was reached with Tab. After a click, or when a dialog that was opened by a click gives the focus
 * back, it plays and pauses as anywhere else.
 */
const reachedByTab = new Set<EventTarget>()

function noteHowFocusMoves(): void {
  let tabbed = false
  addEventListener('pointerdown', () => reachedByTab.clear())
  addEventListener('keydown', (event) => {
    tabbed = event.key === 'Tab'
  })
  addEventListener('focusin', (event) => {
    if (tabbed && event.target) reachedByTab.add(event.target)
    tabbed = false
  })
}
