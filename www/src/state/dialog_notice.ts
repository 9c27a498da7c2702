/** A message about the open dialog, shown over it: what lies beneath a dialog is dimmed. */
import { signal } from '@preact/signals'

const LIFETIME_MS = 12_000

export const dialogNotice = signal('')
let timer: ReturnType<typeof setTimeout> | undefined

export function tellInDialog(message: string): void {
  clearTimeout(timer)
  dialogNotice.value = message
  timer = setTimeout(dismissInDialog, LIFETIME_MS)
}

export function dismissInDialog(): void {
  clearTimeout(timer)
  dialogNotice.value = ''
}
