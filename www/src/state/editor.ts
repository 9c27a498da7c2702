/** The further tools for drawing: fetched when one of them is first wanted. */
import { signal } from '@preact/signals'
import { type EditorPart, lazyParts } from './lazy_parts'
import { notifyError } from './notices'

export const editor = signal<EditorPart | null>(null)

export function withEditor(use: (editor: EditorPart) => void): void {
  void lazyParts
    .editor()
    .then((part) => {
      use(part)
      editor.value = part
    })
    .catch(notifyError)
}
