/** What scripts ask of the page, fetched with the first call that takes time. */
import type { Notice, ReportLanguage, ResultFile } from '@pkg/formicarium'
import { badOption, optionsOf, ScriptError, typed, wholeNumber } from '../model/script_error'
import type {
  CompareOptions,
  ComparisonResult,
  LoadOptions,
  Opened,
  RunOptions,
} from '../model/scripting'
import {
  isIdle,
  latest,
  lesson,
  loadSession,
  type Panel,
  panels,
  pause,
  phase,
  readied,
  runOn,
  setScenario,
  showView,
  stepIteration,
  stopsMet,
} from '../state'
import { lazyParts } from '../state/lazy_parts'
import { awaited } from '../state/looking'
import { allowed } from '../state/memory'
import { inTurn, type Turn } from '../state/openings'
import { offerOrder } from '../state/order_play'
import { type Content, contentOf } from '../state/script_files'
import { suitSpeed } from '../state/speed'

const POLL_MS = 30
const MOST_ITERATIONS = 1_000_000

export const load = (source: unknown, options?: LoadOptions): Promise<Opened> =>
  typed(async () => {
    if (source === null || !['string', 'object'].includes(typeof source))
      throw badOption('source', 'must be a link, a text, a file, several files or a session')
    let opened: Opened | null = null
    const whole = await inTurn([nameOf(source)], async (turn) => {
      const content = await contentOf(source, options)
      turn.check()
      opened = await show(content, turn)
    })
    if (whole && opened) return opened
    const hint = 'Wait for one call before the next.'
    throw new ScriptError('opening-ended', '', 'something else was opened meanwhile', hint)
  })

const nameOf = (source: unknown) => (source instanceof File ? source.name : 'script')

async function show(content: Content, turn: Turn): Promise<Opened> {
  const { kind, name, notices } = content
  if (kind === 'session') {
    const session = await readied(content.session)
    turn.check()
    showView('race')
    loadSession(session)
  } else if (kind === 'comparison') {
    const { openComparisonDocument } = await lazyParts.lab()
    turn.check()
    showView('lab')
    await openComparisonDocument(content.text, content.told)
  } else if (kind === 'results') await join(content, turn)
  else if (kind === 'order') await offerOrder(content.file, content.tour, () => turn.check())
  else {
    pause()
    if (kind === 'map') suitSpeed(content.scenario)
    setScenario(content.scenario, { undoable: true })
  }
  return { kind, name, notices: notices.map(plain) }
}

const plain = ({ kind, message }: Notice) => ({ kind, message })

async function join(
  { file, name, instance, leaveOut }: Content & { kind: 'results' },
  turn: Turn,
): Promise<void> {
  const { joinForScript } = await import('../lab')
  turn.check()
  showView('lab')
  await joinForScript(name, file.bytes, instance, leaveOut)
}

export const run = (given?: RunOptions): Promise<void> =>
  typed(async () => {
    const { iterations, stops = 'hold' } = optionsOf(given, ['iterations', 'stops'], 'run')
    if (stops !== 'hold' && stops !== 'ignore') throw badOption('stops', 'must be hold or ignore')
    if (stops === 'ignore' && iterations !== undefined) {
      const hint = 'Only runs to the end pass stops over; leave one of the two out.'
      throw new ScriptError('options-exclude', 'stops', 'iterations are counted to a stop', hint)
    }
    const count =
      iterations === undefined ? null : wholeNumber(iterations, 'iterations', 0, MOST_ITERATIONS)
    if (panels.peek().length === 0) {
      const hint = 'Load a session with planners, or add one on the page.'
      throw new ScriptError('no-planner', '', 'there is no planner to run', hint)
    }
    if (!allowed()) {
      const hint = 'Remove planners, or take a smaller map or fewer ants.'
      throw new ScriptError('too-much-memory', 'panels', 'these runs take too much memory', hint)
    }
    // A script says itself where to stop.
    awaited.value = null
    if (count === null) await finishAll(stops === 'ignore')
    else for (let i = 0; i < count && !(i > 0 && hasMet()); i++) await oneIteration()
  })

export const look = (iteration: unknown): Promise<void> =>
  typed(async () => {
    if (iteration === undefined)
      throw badOption('iteration', 'must be a whole number, or null for now')
    const to =
      iteration === null
        ? Number.POSITIVE_INFINITY
        : wholeNumber(iteration, 'iteration', 0, MOST_ITERATIONS)
    const { lookTo, settle } = await import('../playback/look_back')
    lookTo(to)
    await settle()
  })

export const compare = (options?: CompareOptions): Promise<ComparisonResult> =>
  typed(async () => {
    const lab = await import('../lab')
    await lab.fetchLab()
    return lab.compare(options)
  })

export const resultFile = (kind: ResultFile, language?: ReportLanguage): Promise<string> =>
  typed(async () => {
    const lab = await import('../lab')
    await lab.fetchLab()
    return lab.resultFile(kind, language)
  })

/** Whether a stop holds the runs. */
const hasMet = () => stopsMet.peek().length > 0

async function finishAll(through: boolean): Promise<void> {
  await until(() => panels.peek().every(settled))
  runOn(through)
  await until(() => phase.peek() !== 'running' || panels.peek().every(ended))
  if (panels.peek().every(ended) || hasMet()) return
  throw interrupted()
}

function interrupted(): ScriptError {
  const hint = 'Call run again to go on.'
  return new ScriptError('run-ended', '', 'the runs were paused or reset before their end', hint)
}

async function oneIteration(): Promise<void> {
  await until(() => panels.peek().every(settled))
  const all = panels.peek()
  const before = all.map(iterationOf)
  const isThere = () =>
    panels.peek() === all &&
    all.every((panel, i) => ended(panel) || iterationOf(panel) > (before[i] ?? 0))
  stepIteration()
  await until(() => isThere() || isIdle())
  // The last answer may be taken in with the frame after it.
  if (!isThere()) await new Promise(requestAnimationFrame)
  if (!isThere() && !hasMet()) throw interrupted()
  // What was met is said with the frame after the last answer.
  if (lesson.peek()?.stops) await new Promise(requestAnimationFrame)
}

const iterationOf = (panel: Panel) => latest(panel.id).summary?.iteration ?? 0

/** Whether its run is loaded, or refused for a reason that will not go away by waiting. */
function settled(panel: Panel): boolean {
  const { summary, error, crashed } = latest(panel.id)
  return summary !== null || error !== null || crashed !== null
}

function ended(panel: Panel): boolean {
  const { summary, error, crashed } = latest(panel.id)
  return error !== null || crashed !== null || (summary !== null && summary.status !== 'running')
}

async function until(met: () => boolean): Promise<void> {
  while (!met()) await new Promise((resolve) => setTimeout(resolve, POLL_MS))
}
