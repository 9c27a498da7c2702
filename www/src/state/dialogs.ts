/** Which dialog is open: one at a time. */
import { signal } from '@preact/signals'

export type DialogName =
  | 'share'
  | 'import'
  | 'export'
  | 'generate'
  | 'resize'
  | 'help'
  | 'lessons'
  | 'paper'
  | 'order'
  | 'names'
  | 'picture'
  | 'film'
  | 'about'

export const openDialog = signal<DialogName | null>(null)

export function show(name: DialogName): void {
  openDialog.value = name
}

export function closeDialog(): void {
  openDialog.value = null
}
