/** The further tools for drawing: fetched when one of them is first wanted. */
import { signal } from '@preact/signals'
import { type EditorPart, lazyParts } from './lazy_parts'
import { notifyError } from './notices'

export const editor = signal<EditorPart | null>(null)

/** At once where they are here already: the next key may count on them. */
export function withEditor(use: (editor: EditorPart) => void): void {
  const here = editor.peek()
  if (here) {
    use(here)
    return
  }
  void lazyParts
    .editor()
    .then((part) => {
      use(part)
      editor.value = part
    })
    .catch(notifyError)
}
