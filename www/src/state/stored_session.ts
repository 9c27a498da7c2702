/**
 * Keeps the session through a reload: in the tab's own storage, written as a share link is, so that two tabs never mix. A link
 * in the address goes before it.
 */
import { effect } from '@preact/signals'
import { gallery } from '../gallery/gallery'
import type { Session } from '../model/session'
import { canKeep } from '../model/storage'
import { askBeforeLeaving } from './leaving'
import { lesson } from './lesson'
import { inspected, lookedAt } from './looking'
import { notify } from './notices'
import { canUndo, fromGallery } from './scenarios'
import { currentSession, firstSession, loadSession, readied } from './sessions'
import { caption, galleryId, layer, panels, scenario, seed, speed, sync } from './store'
import { SESSION_KEY as KEY } from './stored_key'

/** Waits until a drag has ended. */
const SETTLE_MS = 400
/** Larger maps would take too long to pack while the reader draws, and fill the storage. */
const MOST_CELLS = 1 << 20

export function storeSessionChanges(): void {
  let timer = 0
  effect(() => {
    scenario.value
    panels.value
    seed.value
    sync.value
    speed.value
    layer.value
    caption.value
    lookedAt.value
    inspected.value
    lesson.value
    clearTimeout(timer)
    timer = window.setTimeout(storeSession, SETTLE_MS)
  })
}

/** Opens the session that the tab has stored. False when there is none that this version can read. */
export async function openStoredSession(): Promise<boolean> {
  const kept = read()
  if (!kept) return false
  try {
    const { decodeFragment } = await import('../share/link')
    const session = await decodeFragment(kept)
    const [id] = kept.split('#')
    if (gallery.some((entry) => entry.id === id)) fromGallery(id ?? '', session.scenario)
    loadSession(await readied(session))
    return true
  } catch {
    write(null)
    return false
  }
}

let latest = 0

async function storeSession(): Promise<void> {
  if (!canKeep()) return askBeforeLeaving('map', canUndo.peek())
  const turn = ++latest
  const session = unrun(currentSession())
  if (!session) return
  const text = await packed(session).catch(() => null)
  // A session packed meanwhile is newer.
  if (turn !== latest) return
  write(text)
  const isKept = text === null ? isFirst(session) : read() === text
  askBeforeLeaving('map', !isKept && canUndo.peek())
}

/** The key of the built-in map, if it is one, then a link's fragment; null when there is nothing worth storing. */
async function packed(session: Session): Promise<string | null> {
  if (session.scenario.cells.length > MOST_CELLS || isFirst(session)) return null
  const id = galleryId.peek() ?? ''
  const { encodeSession } = await import('../share/link')
  return `${id}#x=${await encodeSession(session)}`
}

/** On the map as it is, without results: after a reload the runs begin again, and nothing is to be verified. */
function unrun(session: Session | null): Session | null {
  if (!session) return null
  const { changes: _, ...still } = session
  return { ...still, panels: session.panels.map((p) => ({ ...p, result: null })) }
}

function isFirst(session: Session): boolean {
  const plain = ({ scenario: { cells, ...rest }, ...others }: Session) =>
    JSON.stringify({ ...others, ...rest, cells: cells.join('') })
  const first = firstSession()
  // Most sessions differ in size already.
  return (
    first.scenario.cells.length === session.scenario.cells.length && plain(first) === plain(session)
  )
}

/** Private windows and frames in a sandbox may refuse storage, and it may be full: then nothing is stored. */
function write(text: string | null): void {
  try {
    sessionStorage.removeItem(KEY)
    if (text !== null) sessionStorage.setItem(KEY, text)
  } catch (error) {
    const isFull = error instanceof DOMException && error.name === 'QuotaExceededError'
    if (!isFull && !toldOfRefusal) void tellRefusal().catch(() => {})
  }
}

let toldOfRefusal = false

async function tellRefusal(): Promise<void> {
  toldOfRefusal = true
  const { addEmbedWords, t } = await import('../i18n/embed')
  await addEmbedWords()
  notify('info', t('embed.notKept'), { hint: t('embed.notKeptHint') })
}

function read(): string | null {
  if (!canKeep()) return null
  try {
    return sessionStorage.getItem(KEY)
  } catch {
    return null
  }
}
