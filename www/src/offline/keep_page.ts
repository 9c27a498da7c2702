/** The page for days without a network: the browser keeps a copy of it, and a newer version waits there until it is asked for. */
import { signal } from '@preact/signals'
import { numbers } from '../i18n'
import { addOfflineWords, t } from '../i18n/offline'
import type { KeepRequest, KeptPage } from '../model/kept_page'
import { canKeep } from '../model/storage'
import { notify, notifyError, reloadPage } from '../state'
import { changesOf } from './changes'

/**
 * unknown: not looked yet · impossible: this browser, address or frame keeps nothing · off: the reader wants no copy ·
 * fetching: on its way · failed: did not come, and is tried again with the next visit · kept: see `copy`
 */
export type Keeping = 'unknown' | 'impossible' | 'off' | 'fetching' | 'failed' | 'kept'

export const keeping = signal<Keeping>('unknown')
export const copy = signal<KeptPage | null>(null)

/** Whether the reader wants a copy; without an entry it is made. */
const WISH = 'formicarium.offline'
const UNWANTED = 'no'
/** A page that stays open for days looks again when it comes into sight. */
const LOOK_AGAIN_MS = 60 * 60 * 1000

let registration: ServiceWorkerRegistration | null = null

/** Makes the copy, or looks at it; called when the page rests. */
export async function keepPage(): Promise<void> {
  await addOfflineWords()
  if (!isPossible()) keeping.value = 'impossible'
  else if (isUnwanted()) keeping.value = 'off'
  else await register()
}

/** Makes the copy after all. */
export async function wantCopy(): Promise<void> {
  write(null)
  await register()
}

/** Lets go of the copy, and makes none in the future. */
export async function dropCopy(): Promise<void> {
  write(UNWANTED)
  await ask({ ask: 'forget' })
  registration = null
  copy.value = null
  keeping.value = 'off'
}

/** Uses the newer version; what is on the page is kept, runs begin anew. */
export async function useNewer(): Promise<void> {
  await ask({ ask: 'use-newer' })
  reloadPage()
}

/** Frames of other pages keep nothing: who embeds the page decides what stands there. */
const isPossible = () =>
  canKeep() && 'serviceWorker' in navigator && isSecureContext && window.top === window

async function register(): Promise<void> {
  const isFirst = navigator.serviceWorker.controller === null
  if (isFirst) keeping.value = 'fetching'
  try {
    registration = await navigator.serviceWorker.register('./sw.js', { updateViaCache: 'none' })
  } catch {
    keeping.value = isFirst ? 'failed' : 'kept'
    if (isFirst) return
  }
  registration?.addEventListener('updatefound', () => watch(registration?.installing ?? null))
  watch(registration?.installing ?? null)
  if (registration?.active) await look()
  lookAgainInSight()
}

/** Follows a worker that fetches its version, until it has it. */
function watch(worker: ServiceWorker | null): void {
  worker?.addEventListener('statechange', () => {
    if (worker.state === 'activated') void look(true)
    if (worker.state === 'redundant' && copy.peek() === null) keeping.value = 'failed'
  })
}

async function look(isNew = false): Promise<void> {
  const before = copy.peek()
  const found = await ask({ ask: 'look' })
  if (!found) return
  copy.value = found
  keeping.value = 'kept'
  if (found.newer) tellNewer(found)
  else if (isNew && !before) tellKept(found)
}

/** Nothing is stored without being said. */
function tellKept({ bytes }: KeptPage): void {
  notify('info', t('offline.kept', { size: megabytes(bytes) }), { hint: t('offline.keptHint') })
}

function tellNewer({ used, newer }: KeptPage): void {
  if (!newer) return
  const action = { label: t('offline.use'), run: () => void useNewer().catch(notifyError) }
  notify('info', t('offline.newer'), { hint: changesOf(used, newer), action, stays: true })
}

export const megabytes = (bytes: number) => numbers.peek().metres.format(bytes / 1e6)

/** What the service worker says; null where none is there. */
function ask(request: KeepRequest): Promise<KeptPage | null> {
  const worker = registration?.active ?? navigator.serviceWorker.controller
  if (!worker) return Promise.resolve(null)
  const { port1, port2 } = new MessageChannel()
  return new Promise((resolve) => {
    port1.onmessage = ({ data }) => resolve(data)
    worker.postMessage(request, [port2])
  })
}

function lookAgainInSight(): void {
  let last = Date.now()
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState !== 'visible' || Date.now() - last < LOOK_AGAIN_MS) return
    last = Date.now()
    registration?.update().catch(() => {})
  })
}

function isUnwanted(): boolean {
  try {
    return localStorage.getItem(WISH) === UNWANTED
  } catch {
    return false
  }
}

function write(wish: string | null): void {
  try {
    if (wish === null) localStorage.removeItem(WISH)
    else localStorage.setItem(WISH, wish)
  } catch {}
}
