/** Messages to the reader: toasts that stay until read, and words for the screen reader alone. */

import type { EngineError } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { describeError } from '../i18n/errors'

export type Tone = 'info' | 'success' | 'warning' | 'error'

export interface Toast {
  id: number
  tone: Tone
  message: string
  hint: string
  action: { label: string; run: () => void } | null
}

export const toasts = signal<Toast[]>([])
/** Text for the polite aria-live region. */
export const announcement = signal('')

const MAX_TOASTS = 3
const LIFETIME_MS: Record<Tone, number> = { info: 6000, success: 5000, warning: 12000, error: 0 }
let nextId = 1

export function announce(text: string): void {
  // The same words twice in a row are read only when the text node changes.
  announcement.value = announcement.peek() === text ? `${text}\u00a0` : text
}

export function notify(
  tone: Tone,
  message: string,
  options: { hint?: string; action?: Toast['action']; stays?: boolean } = {},
): number {
  const same = toasts.value.find((toast) => toast.message === message)
  if (same) dismiss(same.id)
  const toast = {
    id: nextId++,
    tone,
    message,
    hint: options.hint ?? '',
    action: options.action ?? null,
  }
  toasts.value = [...toasts.value, toast].slice(-MAX_TOASTS)
  const lifetime = options.stays ? 0 : LIFETIME_MS[tone]
  if (lifetime > 0) setTimeout(() => dismiss(toast.id), lifetime)
  return toast.id
}

export function dismiss(id: number): void {
  toasts.value = toasts.value.filter((toast) => toast.id !== id)
}

export function notifyError(error: unknown): void {
  const { message, hint } = describeError(error)
  notify('error', message, { hint })
}

export type { EngineError }
