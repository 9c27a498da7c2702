/** Messages to the reader: toasts that stay long enough to be read, and words for the screen reader alone. */

import type { EngineError } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { t } from '../i18n'
import { describeError } from '../i18n/errors'
import { isEngineError } from '../model/errors'

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
/** Counted anew when pointer and focus have left it. */
const LIFETIME_MS: Record<Tone, number> = {
  info: 6000,
  success: 5000,
  warning: 12000,
  error: 20000,
}
/** Of the toasts that go by themselves. */
const endings = new Map<number, { lifetime: number; timer: number }>()
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
  if (!options.stays) endings.set(toast.id, { lifetime: LIFETIME_MS[tone], timer: 0 })
  goOn(toast.id)
  return toast.id
}

/** A toast under the pointer, or with the focus, stays. */
export function hold(id: number): void {
  clearTimeout(endings.get(id)?.timer)
}

export function goOn(id: number): void {
  const ending = endings.get(id)
  if (!ending) return
  clearTimeout(ending.timer)
  ending.timer = window.setTimeout(() => dismiss(id), ending.lifetime)
}

export function dismiss(id: number): void {
  hold(id)
  endings.delete(id)
  toasts.value = toasts.value.filter((toast) => toast.id !== id)
}

export function notifyError(error: unknown): void {
  const { message, hint } = describeError(error)
  const action = isOutdated(error) ? { label: t('app.reload'), run: reloadPage } : null
  notify('error', message, { hint, action, stays: action !== null })
}

/** Only a newer version of the page can help. */
export const isOutdated = (error: unknown) => isEngineError(error) && error.kind === 'page-outdated'

/** What is on the page has been stored (state/stored_session.ts). */
export const reloadPage = () => location.reload()

export type { EngineError }
