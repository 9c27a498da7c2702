/** A session as a value: taken from the page, put back on it, and verified against what it recorded. */
import { batch } from '@preact/signals'
import { buildFor } from '../engine/builds'
import { tools } from '../engine/tools'
import { firstScenario } from '../gallery/gallery'
import { t } from '../i18n'
import { DEFAULT_SPEED, MAX_PANELS, type RecordedResult, type Session } from '../model/session'
import { goTo } from './address'
import { reducedMotion } from './appearance'
import { exchange } from './history'
import { fetchNames, lazyParts } from './lazy_parts'
import { guide, LESSON_PREFIX, lesson } from './lesson'
import { latest, setVerified } from './live_reports'
import { awaited, awaitLook, currentLook } from './looking'
import { held, holdIfLarge, tellHeld } from './memory'
import { notify, notifyError } from './notices'
import { playWhenShown } from './page_view'
import { bareSetup, makePanel, removePanel } from './panels'
import { tellReceived } from './received'
import { dropRun, leadIn, pause, play, reset, restart, runSetup, walls } from './runs'
import { fromGallery, setScenario } from './scenarios'
import { setSpeedOfSession } from './speed'
import {
  caption,
  layer,
  type Panel,
  panelById,
  panels,
  phase,
  plannerEntry,
  scenario,
  seed,
  selectedPanel,
  speed,
  sync,
  wholeEngine,
} from './store'

const FIRST_PLANNERS = ['ant-system', 'astar']
const FIRST_MAP = 'two-corridors'

export function currentSession(): Session | null {
  const now = scenario.peek()
  if (!now) return null
  return {
    scenario: now,
    panels: panels.peek().map((panel) => ({ ...panel.setup, result: recordedResult(panel) })),
    seed: seed.peek(),
    sync: sync.peek(),
    speed: speed.peek(),
    layer: layer.peek(),
    ...caption.peek(),
    ...currentLook(),
    lesson: lesson.peek() ?? undefined,
    ...walls.inSession?.(),
  }
}

/** With what it takes to load it. */
export async function readied(session: Session): Promise<Session> {
  if (session.changes || session.keepTrails) await lazyParts.walls()
  return session
}

export function loadSession(session: Session): void {
  pause()
  for (const panel of panels.peek()) dropRun(panel.id)
  batch(() => {
    holdIfLarge()
    seed.value = session.seed
    sync.value = session.sync
    setSpeedOfSession(session.speed)
    layer.value = session.layer
    lesson.value = session.lesson ?? null
    panels.value = []
    const swap = exchange(caption, { title: session.title, note: session.note })
    setScenario(session.scenario, { undoable: scenario.peek() !== null, swap })
    panels.value = session.panels.slice(0, MAX_PANELS).map(makePanel)
    selectedPanel.value = panels.value[0]?.id ?? null
    awaitLook(session)
    const ids = panels.value.map(({ id }) => id)
    if (wholeEngine.peek() === 'here') dropUnknown(panels.value)
    walls.next?.(session, ids)
    reset()
  })
  if (awaited.peek() || session.title || session.note) fetchNames().catch(notifyError)
  for (const panel of panels.peek()) void verify(panel)
}

/** For when the catalog is complete: panels that waited for it are verified, or removed if this version does not know their planner. */
export function admitWaiting(): void {
  const waiting = panels.peek().filter(({ setup }) => buildFor(setup.planner) === 'whole')
  dropUnknown(waiting)
  for (const { id } of waiting) {
    const panel = panelById(id)
    if (panel) void verify(panel)
  }
  // After a failure the workers of these panels have given up, and all panels must start together.
  if (waiting.some(({ id }) => latest(id).crashed !== null)) restart()
}

/** Opens what the address carries. False when it carries nothing or nothing usable; the page then stays as it is. */
export async function openFragment(hash: string): Promise<boolean> {
  try {
    if (hash.startsWith(LESSON_PREFIX))
      return await (await lazyParts.opener()).openText(hash, { unasked: true })
    if (!hash.startsWith('#x=')) return false
    const { decodeFragment } = await import('../share/link')
    loadSession(await readied(await decodeFragment(hash)))
    tellReceived()
    return true
  } catch (error) {
    notifyError(error)
    return false
  }
}

export function openFirstSession(): void {
  const session = firstSession()
  fromGallery(FIRST_MAP, session.scenario)
  loadSession(session)
  leadIn()
}

/** As on a first visit. A link in the address is left behind, or a reload would bring it back. */
export function startOver(): void {
  goTo('', 'replace')
  openFirstSession()
  autoplay()
}

export function firstSession(): Session {
  return {
    scenario: firstScenario(),
    panels: FIRST_PLANNERS.map(bareSetup),
    seed: 1,
    sync: 'moves',
    speed: DEFAULT_SPEED,
    layer: 'trail',
    title: '',
    note: '',
    look: null,
    inspected: null,
  }
}

/**
 * Plays at once but for a lesson, whose question comes first, or, when the reader prefers less motion, after the first key or click. What
 * takes much memory waits until somebody asks for it.
 */
export function autoplay(): void {
  if (guide.peek() !== null) return
  if (held.peek()) {
    tellHeld(play)
    return
  }
  if (!reducedMotion()) {
    playWhenShown()
    return
  }
  notify('info', t('notices.calm'), { hint: t('notices.calmHint') })
  const start = () => {
    removeEventListener('click', start)
    removeEventListener('keydown', start)
    // After the click's own effect: the play button must not be undone by this.
    setTimeout(() => {
      if (phase.peek() === 'editing' && !held.peek()) playWhenShown()
    })
  }
  addEventListener('click', start)
  addEventListener('keydown', start)
}

/** A session of a newer version may name planners this one has not learnt; the others still run. */
function dropUnknown(all: Panel[]): void {
  for (const { id, setup } of all) {
    const { planner } = setup
    if (plannerEntry(planner)) continue
    removePanel(id)
    notify('warning', t('notices.unknownPlanner', { planner }), {
      hint: t('notices.unknownPlannerHint'),
    })
  }
}

/** What the run has reached; before its first iteration, what the opened session had recorded. */
function recordedResult(panel: Panel): RecordedResult | null {
  const { summary } = latest(panel.id)
  if (!summary || summary.iteration === 0) return panel.setup.result
  return {
    iterations: summary.iteration,
    status: summary.status,
    length: summary.metrics?.length ?? null,
    digest: summary.digest,
  }
}

/** Panels whose runs are repeated once the race may run. */
const waitingToVerify = new Set<number>()

export function verifyWaiting(): void {
  const ids = [...waitingToVerify]
  waitingToVerify.clear()
  for (const id of ids) {
    const panel = panelById(id)
    if (panel) void verify(panel)
  }
}

/** Repeats a recorded run in the background: bit for bit the same, or said to differ. */
async function verify(panel: Panel): Promise<void> {
  const recorded = panel.setup.result
  const now = scenario.peek()
  if (!recorded || !now) return
  setVerified(panel.id, 'pending')
  if (held.peek()) {
    waitingToVerify.add(panel.id)
    return
  }
  if (!plannerEntry(panel.setup.planner)) return
  try {
    const summary = await tools.replay(runSetup(panel, now), recorded)
    if (panelById(panel.id)?.setup.result !== recorded) return
    setVerified(panel.id, summary.digest === recorded.digest ? 'verified' : 'differs')
  } catch {
    setVerified(panel.id, 'differs')
  }
}
