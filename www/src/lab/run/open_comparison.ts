/** The open comparison from its opening to its end: its parts, and what is shown of it. */
import { batch, effect } from '@preact/signals'
import { t } from '../../i18n/lab'
import { type ComparisonDocument, documentOf, textOf } from '../../model/comparison'
import type { KeptRun, Opened } from '../../model/comparison_calls'
import { canKeep } from '../../model/storage'
import { checkNumbers, type NumbersOfLink } from '../../share/recorded_numbers'
import { noShare, readShare, type ShareOfClass, shareText } from '../../share/share_of_class'
import { notify, notifyError } from '../../state'
import { embedding } from '../../state/embedding'
import {
  type BroughtFile,
  ComparisonWriter,
  type StoredComparison,
  storedComparison,
} from '../store/browser_storage'
import { refreshKeptComparisons } from '../store/kept_comparisons'
import { newId } from '../store/names'
import {
  analysis,
  analysisError,
  axis,
  failures,
  finishing,
  NO_PROGRESS,
  type OpenComparison,
  openComparison,
  phase,
  progress,
  verification,
} from '../store/signals'
import { isLocked, whenUnlocked } from '../store/tab_lock'
import { COMPARISON_IN_TAB, rememberInTab } from '../store/tab_memory'
import { keepUnstored, noteUnstored, unstored } from '../store/unstored'
import { AnalystClient } from './analyst_client'
import { firstOfEach } from './failures'
import { Runner } from './runner'
import { Tasks } from './tasks'

/** What belongs to the open comparison and ends with it. */
export interface OpenParts {
  comparison: OpenComparison
  stored: StoredComparison
  tasks: Tasks
  analyst: AnalystClient
  runner: Runner
  writer: ComparisonWriter
  /** Releases the lock that keeps other tabs from running it; null while this tab does not hold it. */
  unlock: (() => void) | null
  closed: AbortController
}

/** The run bar is updated no more often than this. */
const SHOW_MS = 500

let current: OpenParts | null = null
let shown = 0

/** The parts of the comparison that is open now. */
export const openParts = (): OpenParts | null => current

export interface NewComparison {
  document: string
  runs: OpenComparison['runs']
  firstSeeds: number | null
  workers?: number | undefined
  /** Runs of it that are done already. */
  done?: KeptRun[] | undefined
  /** What a link tells of its runs. */
  numbers?: NumbersOfLink | null
  /** The share of a class that is to be done; all runs where there is none. */
  share?: ShareOfClass | null
  /** Files that have brought runs among the done ones. */
  brought?: BroughtFile[] | undefined
}

/** Opens a document as a new comparison. */
export async function openNew({
  document,
  runs,
  firstSeeds,
  workers,
  done,
  numbers = null,
  share = null,
  brought = [],
}: NewComparison): Promise<void> {
  // The builder stays on show until its comparison runs or is refused by the engine.
  if (phase.peek() === 'idle' && runs === 'file') phase.value = 'opening'
  const analyst = new AnalystClient(document, tell, trouble)
  try {
    const opened = await analyst.open()
    const rows = done ?? opened.rows
    const parsed = documentOf(document)
    if (numbers) checkNumbers(numbers, parsed.question)
    if (share && share.of > opened.mostShares) throw noShare(shareText(share))
    const stored: StoredComparison = {
      id: newId(),
      title: parsed.question.title,
      document: textOf(withoutRows(parsed)),
      runs: rows.length > 0 ? runs : 'own',
      firstSeeds,
      created: Date.now(),
      done: 0,
      total: 0,
      ...(numbers && { numbers }),
      ...(share && { share: shareText(share) }),
      brought,
    }
    await begin(stored, { analyst, opened }, rows, { workers, isNew: true })
  } catch (error) {
    analyst.close()
    if (phase.peek() === 'opening') phase.value = 'idle'
    throw error
  }
}

export async function openKeptComparison(id: string): Promise<void> {
  const found = unstored(id) ?? (await storedComparison(id))
  if (!found) {
    if (canKeep()) notify('warning', t('lab.kept.gone'))
    await refreshKeptComparisons()
    return
  }
  const { comparison: stored, runs } = found
  await openStored(stored, runs)
}

/** A comparison that the browser has stored. */
async function openStored(stored: StoredComparison, runs: KeptRun[]): Promise<void> {
  phase.value = 'opening'
  const analyst = new AnalystClient(stored.document, tell, trouble)
  try {
    const opened = await analyst.open()
    await begin(stored, { analyst, opened }, runs, { isNew: false })
  } catch (error) {
    analyst.close()
    phase.value = openComparison.peek() ? 'paused' : 'idle'
    throw error
  }
}

async function begin(
  stored: StoredComparison,
  { analyst, opened }: { analyst: AnalystClient; opened: Opened },
  runs: KeptRun[],
  { workers, isNew }: { workers?: number | undefined; isNew: boolean },
): Promise<void> {
  leave()
  for (const run of runs) analyst.keep(run)
  const { question, maps, recorded = null } = documentOf(stored.document)
  const { id, title, document, firstSeeds } = stored
  const now: OpenComparison = {
    id,
    title,
    document,
    question,
    maps,
    outline: opened.outline,
    recorded,
    numbers: stored.numbers ?? null,
    runs: stored.runs,
    firstSeeds,
    digest: opened.digest,
    mostShares: opened.mostShares,
    share: stored.share === undefined ? null : readShare(stored.share),
    dealt: stored.dealt ?? null,
    brought: stored.brought ?? [],
    elsewhere: false,
  }
  const tasks = new Tasks(opened)
  const writer = new ComparisonWriter(stored, (error) => refused(id, error))
  const runner: Runner = new Runner({
    comparison: now,
    analyst,
    tasks,
    writer,
    kept: runs.length,
    workers,
    changed: () => mine === current && changed(mine),
    rested: () => mine === current && comeToRest(mine),
  })
  const closed = new AbortController()
  const mine: OpenParts = {
    comparison: now,
    stored,
    tasks,
    analyst,
    runner,
    writer,
    unlock: null,
    closed,
  }
  if (stored.share !== undefined && now.share?.index != null)
    runner.restrict(await analyst.dealt(stored.share))
  stored.total = runner.progress.total
  if (isNew) for (const run of runs) writer.keep(run)
  current = mine
  rememberInTab(COMPARISON_IN_TAB, id)
  batch(() => {
    openComparison.value = now
    analysis.value = null
    analysisError.value = null
    verification.value = null
    failures.value = []
    finishing.value = 0
    showAtRest(mine)
  })
  if (isNew) void writer.flush()
  else if (await isLocked(id)) waitForOther(mine)
}

/** Shows the state in which nothing runs. */
function showAtRest(mine: OpenParts): void {
  progress.value = mine.runner.progress
  failures.value = firstOfEach(mine.runner.failures)
  finishing.value = 0
  phase.value = mine.runner.isComplete ? 'done' : 'paused'
  void mine.analyst.look(true)
}

/** Shows that which runs there are has changed. */
export function refresh(mine: OpenParts): void {
  if (mine !== current) return
  if (phase.peek() === 'running') changed(mine)
  else batch(() => showAtRest(mine))
}

/** Changes what is told of the comparison beside its runs, and stores it. */
export async function amend(mine: OpenParts, change: Amendment): Promise<void> {
  const { share, ...rest } = change
  Object.assign(mine.stored, rest)
  if (share) mine.stored.share = shareText(share)
  else if (share === null) delete mine.stored.share
  mine.stored.total = mine.runner.progress.total
  mine.comparison = { ...mine.comparison, ...change }
  if (mine === current) openComparison.value = mine.comparison
  await mine.writer.flush()
}

type Amendment = Partial<Pick<OpenComparison, 'brought' | 'share'> & { dealt: number }>

/** The last run under way has ended. */
export function comeToRest(mine: OpenParts): void {
  mine.runner.halt()
  batch(() => showAtRest(mine))
  void mine.writer.flush().then(() => {
    if (phase.peek() === 'running') return
    mine.unlock?.()
    mine.unlock = null
  })
}

export function changed(mine: OpenParts): void {
  mine.analyst.lookSoon()
  if (shown !== 0) return
  shown = window.setTimeout(() => {
    shown = 0
    if (mine !== current) return
    batch(() => {
      progress.value = mine.runner.progress
      failures.value = firstOfEach(mine.runner.failures)
      if (phase.peek() === 'paused') finishing.value = mine.runner.inFlight
    })
  }, SHOW_MS)
}

/** Another tab runs it: this one shows how far it had come, and opens it again once the other tab has let go. */
export function waitForOther(mine: OpenParts): void {
  mine.comparison = { ...mine.comparison, elsewhere: true }
  openComparison.value = mine.comparison
  void whenUnlocked(mine.comparison.id, mine.closed.signal).then(() => {
    if (mine === current) openKeptComparison(mine.comparison.id).catch(notifyError)
  })
}

/** Takes in runs that another tab has done since it was opened here. */
export async function takeInFromOthers(mine: OpenParts): Promise<void> {
  const found = await storedComparison(mine.comparison.id).catch(() => null)
  for (const run of found?.runs ?? []) if (!mine.analyst.has(run.index)) mine.analyst.keep(run)
  if (found) mine.stored.done = Math.max(mine.stored.done, found.runs.length)
  mine.runner.recount()
}

/** Afterwards no comparison is open; runs are stopped. */
export function closeComparison(): void {
  leave()
  rememberInTab(COMPARISON_IN_TAB, null)
  batch(() => {
    openComparison.value = null
    phase.value = 'idle'
    progress.value = NO_PROGRESS
    analysis.value = null
    analysisError.value = null
    verification.value = null
    failures.value = []
    finishing.value = 0
  })
  void refreshKeptComparisons()
}

function leave(): void {
  if (!current) return
  const { stored, runner, analyst, writer, unlock, closed } = current
  current = null
  if (writer.hasRefused || unstored(stored.id)) keepUnstored(stored, analyst.all)
  runner.end()
  analyst.close()
  closed.abort()
  void writer.flush().then(unlock ?? undefined)
}

function tell(look: { analysis: typeof analysis.value; verification: typeof verification.value }) {
  batch(() => {
    analysis.value = look.analysis
    verification.value = look.verification
    analysisError.value = null
  })
}

function trouble(error: NonNullable<typeof analysisError.value>): void {
  analysisError.value = error
}

let toldOfFrame = false

/** Said once: the runs go on without being stored. */
function refused(id: string, error: unknown): void {
  if (embedding) {
    if (!toldOfFrame) notify('info', t('lab.kept.embedded'), { hint: t('lab.kept.refusedHint') })
    toldOfFrame = true
    return
  }
  // Of the page in one file nobody expects it.
  if (!canKeep()) return
  noteUnstored(id)
  const isFull = error instanceof DOMException && error.name === 'QuotaExceededError'
  notify('warning', t(isFull ? 'lab.kept.full' : 'lab.kept.refused'), {
    hint: t('lab.kept.refusedHint'),
  })
}

function withoutRows({ rows: _, ...document }: ComparisonDocument): ComparisonDocument {
  return document
}

// Another axis needs another analysis of the same runs.
effect(() => {
  axis.value
  void current?.analyst.look(phase.peek() !== 'running')
})
