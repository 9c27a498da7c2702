/**
 * Walls that change while planners run, fetched with the choice to keep the trails or with a session that has changes. A change is made
 * in every panel's worker at the end of the iteration at work there; the number of that iteration is noted for each panel, and with the
 * cells it is all that a session needs to repeat the runs exactly.
 */
import { batch, signal } from '@preact/signals'
import { client } from '../engine/panel_clients'
import { addWallsWords, t } from '../i18n/walls'
import { limits } from '../model/facts'
import type { Frame, PanelAnswers } from '../model/messages'
import type { Scenario, WallChange } from '../model/session'
import { cellsBefore, wallsBetween } from '../model/wall_changes'
import { recall, remember } from './appearance'
import { latest, onReply } from './live_reports'
import { leavePast } from './looking'
import { notify, notifyError } from './notices'
import { dropResults } from './panels'
import { reload, reset, type WallsPart, walls } from './runs'
import { type Panel, panelById, panels, phase, plannerEntry } from './store'

type Walls = Pick<WallChange, 'blocked' | 'freed'>

/** A change of the runs on show; a panel that has not answered yet has no number. */
interface Made extends Walls {
  at: Map<number, number>
}

const KEEP_TRAILS = 'formicarium.keepTrails'

/** The changes of the runs on show, in their order. */
export const madeChanges = signal<readonly Made[]>([])

/** What the next runs begin with. */
let coming: readonly Made[] = []

/** How many of the changes came with the session. */
let ofSession = 0

/** Whether a change of walls keeps the trails; kept on this device. */
export const keepTrails = signal(recall(KEEP_TRAILS) === 'keep')

export function setKeepTrails(keep: boolean): void {
  keepTrails.value = keep
  // Runs that have not begun are loaded on the build that knows changes.
  if (phase.peek() === 'editing') reset()
  remember(KEEP_TRAILS, keep ? 'keep' : '')
}

let started: Promise<void> | null = null

/** Words and seams; the module is of no use before. */
export function startChangingWalls(): Promise<void> {
  started ??= start()
  return started
}

async function start(): Promise<void> {
  await addWallsWords()
  const made = () => madeChanges.value.length
  const part = { show, take, setup, begin, next, inSession, made, since } satisfies WallsPart
  Object.assign(walls, part)
}

/** Whether runs are at work, and an edit of their map changes nothing but its walls. */
function goesOn(before: Scenario, after: Scenario): boolean {
  const atWork = phase.peek() === 'running' || phase.peek() === 'paused'
  const wallsOnly =
    before.spec === after.spec &&
    before.heights === after.heights &&
    before.factors === after.factors
  return keepTrails.peek() && atWork && wallsOnly
}

/** The walls as they are being drawn, before they are on any run's map. */
const show: WallsPart['show'] = (before, after) => {
  if (!goesOn(before, after)) return false
  // What is refused when it is done is not shown either.
  const drawn = isAhead() ? { blocked: [], freed: [] } : wallsOf(before, after)
  for (const { id } of panels.peek()) void client(id)?.ask({ about: 'show-walls', walls: drawn })
  return true
}

const take: WallsPart['take'] = (before, after) => {
  if (before.cells === after.cells || !goesOn(before, after)) return 'anew'
  const action = { label: t('walls.begin'), run: reset }
  if (isAhead()) {
    notify('warning', t('walls.ahead'), { hint: t('walls.aheadHint'), action })
    return 'refused'
  }
  if (madeChanges.peek().length >= limits.max_changes) {
    const hint = t('walls.aheadHint')
    notify('warning', t('walls.most', { most: limits.max_changes }), { hint, action })
    return 'refused'
  }
  leavePast()
  void make(wallsOf(before, after)).catch(failed)
  return 'taken'
}

/** Whether a panel has changes of its session still to come. */
function isAhead(): boolean {
  return panels.peek().some(({ id }) => (latest(id).summary?.changes ?? 0) < ofSession)
}

const wallsOf = (before: Scenario, after: Scenario): Walls =>
  wallsBetween(before.cells, after.cells, before.spec.width)

/** Makes a change in every panel's run. */
async function make(drawn: Walls): Promise<void> {
  const made: Made = { ...drawn, at: new Map() }
  batch(() => {
    madeChanges.value = [...madeChanges.peek(), made]
    dropResults()
  })
  const anew = await Promise.all(panels.peek().map((panel) => makeIn(panel, made)))
  // The numbers have come.
  if (madeChanges.peek().includes(made)) madeChanges.value = [...madeChanges.peek()]
  const names = anew.filter((name) => name !== null)
  notify('info', t('walls.changed'), {
    hint: names.length > 0 ? t('walls.beginAnew', { planners: names.join(', ') }) : '',
  })
}

/** A change that cannot be made would leave runs and map apart. */
function failed(error: unknown): void {
  notifyError(error)
  notify('warning', t('walls.failed'))
  reset()
}

/** The name of the panel's planner where it begins anew. */
async function makeIn(panel: Panel, made: Made): Promise<string | null> {
  const { blocked, freed } = made
  const isLoaded = latest(panel.id).summary !== null
  const answer = isLoaded
    ? await client(panel.id)?.ask({ about: 'walls', walls: { blocked, freed } })
    : null
  // All runs have begun anew meanwhile, or the panel has left.
  if (!madeChanges.peek().includes(made) || !panelById(panel.id)) return null
  if (typeof answer?.at === 'number') takeIn(panel.id, made, answer.at, answer)
  else repeat(panel, made)
  const entry = plannerEntry(panel.setup.planner)
  // The colony of the opening build goes on, its searches begin anew.
  const adapts = answer?.adapts ?? entry?.family === 'ant-colony'
  return adapts ? null : (entry?.name ?? panel.setup.planner)
}

/** Up to which iteration a run is being repeated that has not answered yet. */
const repeating = new Map<number, number>()

/**
 * A run that cannot take the change as it stands, because the opening build knows none or the run is only being loaded: the whole build
 * repeats it up to here, which takes a moment, and goes on with the change.
 */
function repeat(panel: Panel, made: Made): void {
  const iteration = latest(panel.id).summary?.iteration ?? repeating.get(panel.id) ?? 0
  repeating.set(panel.id, iteration)
  made.at.set(panel.id, iteration)
  reload(panel, iteration)
}

/** What has changed with the walls is shown before the next tick. */
function takeIn(id: number, made: Made, at: number, look: PanelAnswers['look']): void {
  made.at.set(id, at)
  const panel = client(id)
  if (!panel?.frame) return
  const { summary, bestPath, bestAltitudes } = look
  const news = { status: summary.status, summary, history: new Float64Array() }
  const frame: Frame = { ...panel.frame, ...news, bestPath, bestAltitudes }
  panel.frame = frame
  onReply(id, frame)
}

/**
 * A run with all changes that have a number for it, on the map before them. With an empty list of them the build is the one that can
 * change walls, and shows what is being drawn.
 */
const setup: WallsPart['setup'] = (panel, bare) => {
  const mine = madeChanges.peek().flatMap(({ blocked, freed, at }) => {
    const iteration = at.get(panel.id)
    return iteration === undefined ? [] : [{ at: iteration, blocked, freed }]
  })
  if (mine.length === 0)
    return keepTrails.peek() ? { ...bare, spec: { ...bare.spec, changes: [] } } : bare
  const cells = cellsBefore(bare.cells, bare.spec.width, mine)
  return { ...bare, cells, spec: { ...bare.spec, changes: mine } }
}

/** Before the session's runs begin. */
const next: WallsPart['next'] = ({ changes = [], keepTrails: keep = false }, ids) => {
  keepTrails.value = keep || keepTrails.peek()
  coming = changes.map(({ at, ...drawn }) => ({
    ...drawn,
    at: new Map(ids.map((id, i) => [id, at[i] ?? 0])),
  }))
  if (changes.length > 0)
    notify('info', t('walls.replayed', { count: changes.length }), {
      hint: t('walls.replayedHint'),
    })
}

/** Every run begins: what has changed is the map now, unless a session brings changes of its own. */
const begin: WallsPart['begin'] = () => {
  repeating.clear()
  madeChanges.value = coming
  ofSession = coming.length
  coming = []
}

const since: WallsPart['since'] = () =>
  Math.max(0, ...(madeChanges.value.at(-1)?.at.values() ?? []))

/** What a session of the runs as they stand has of it. A panel that has not answered will have the change later than it stands now. */
const inSession: WallsPart['inSession'] = () => {
  const changes = madeChanges.peek().map(({ at, ...drawn }) => ({
    ...drawn,
    at: panels.peek().map(({ id }) => at.get(id) ?? (latest(id).summary?.iteration ?? 0) + 1),
  }))
  return {
    ...(changes.length > 0 && { changes }),
    ...(keepTrails.peek() && { keepTrails: true as const }),
  }
}
