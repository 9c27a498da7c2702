/** Memory over all panels: what is large waits to be asked for, what is too large is refused. */
import { computed, signal } from '@preact/signals'
import { language, t } from '../i18n'
import { MOST_BYTES, memoryOf, UNASKED_BYTES } from '../model/memory'
import { dismiss, notify, notifyError } from './notices'
import { panels, scenario } from './store'

/** Bytes that the race on the page holds once it runs. */
export const memoryNeeded = computed(() => {
  const spec = scenario.value?.spec
  return spec
    ? memoryOf(
        spec,
        panels.value.map(({ setup }) => setup),
      )
    : 0
})

/** Nobody has asked yet for what was opened to run. */
const unasked = signal(false)

/** Whether what was opened waits to be asked for. Nothing large is computed before. */
export const held = computed(() => unasked.value && memoryNeeded.value > UNASKED_BYTES)

/** What was opened came from elsewhere: it starts by itself only where it is not large. */
export function holdIfLarge(): void {
  unasked.value = true
}

/** Somebody wants the race to run. False, and said why, where it is too large. */
export function allowed(): boolean {
  if (memoryNeeded.peek() > MOST_BYTES) {
    notifyError({
      kind: 'too-much-memory',
      field: 'panels',
      message: t('notices.tooLarge', sizes()),
      hint: t('notices.tooLargeHint'),
    })
    return false
  }
  unasked.value = false
  return true
}

/** Says that the race waits, and how much it would take. */
export function tellHeld(start: () => void): void {
  const action = { label: t('notices.heldStart'), run: start }
  const hint = t('notices.heldHint')
  const id = notify('warning', t('notices.held', sizes()), { hint, action, stays: true })
  const stop = held.subscribe((waits) => {
    if (waits) return
    dismiss(id)
    queueMicrotask(() => stop())
  })
}

function sizes(): { size: string; most: string; count: number } {
  return {
    size: gibibytes(memoryNeeded.peek()),
    most: gibibytes(MOST_BYTES),
    count: panels.peek().length,
  }
}

const gibibytes = (bytes: number) =>
  new Intl.NumberFormat(language.peek(), { maximumFractionDigits: 1 }).format(bytes / 2 ** 30)
