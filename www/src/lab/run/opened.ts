/** The open experiment from its opening to its end: what belongs to it, and what of it is shown. */
import { batch, effect } from '@preact/signals'
import { t } from '../../i18n/lab'
import { documentOf, type LabDocument, textOf } from '../../model/comparison'
import type { KeptRun } from '../../model/comparison_calls'
import { notify, notifyError } from '../../state'
import { refreshKept, rememberInTab, STUDY_IN_TAB } from '../store/kept'
import { newId } from '../store/names'
import { Keeper, type KeptStudy, keptStudy } from '../store/shelf'
import {
  analysis,
  analysisError,
  axis,
  failures,
  finishing,
  NO_PROGRESS,
  phase,
  progress,
  type Study,
  study,
  verification,
} from '../store/signals'
import { isTaken, whenFree } from '../store/tab_lock'
import { Desk } from './desk'
import { Runner } from './runner'

/** What belongs to the open study and ends with it. */
export interface Open {
  study: Study
  kept: KeptStudy
  desk: Desk
  runner: Runner
  keeper: Keeper
  /** Lets go of the lock that keeps other tabs from running it. */
  letGo: (() => void) | null
  closed: AbortController
}

/** Numbers of a run bar need not come more often. */
const SHOW_MS = 500

let open: Open | null = null
let shown = 0

/** What is open now. */
export const opened = (): Open | null => open

export interface Taken {
  document: string
  runs: Study['runs']
  firstSeeds: number | null
  workers?: number | undefined
  /** Runs of it that are done already. */
  done?: KeptRun[] | undefined
}

/** A document that comes from outside becomes a study. */
export async function take({ document, runs, firstSeeds, workers, done }: Taken): Promise<void> {
  // Whoever has put one together sees it until it runs, or until the engine refuses it.
  if (phase.peek() === 'idle' && runs === 'file') phase.value = 'opening'
  const desk = new Desk(document, tell, trouble)
  try {
    const { rows: brought } = await desk.open()
    const rows = done ?? brought
    const parsed = documentOf(document)
    const kept: KeptStudy = {
      id: newId(),
      title: parsed.question.title,
      document: textOf(withoutRows(parsed)),
      runs: rows.length > 0 ? runs : 'own',
      firstSeeds,
      created: Date.now(),
      done: 0,
      total: 0,
    }
    await begin(kept, desk, rows, { workers, isNew: true })
  } catch (error) {
    desk.close()
    if (phase.peek() === 'opening') phase.value = 'idle'
    throw error
  }
}

export async function openStudy(id: string): Promise<void> {
  const found = await keptStudy(id)
  if (!found) {
    notify('warning', t('lab.kept.gone'))
    await refreshKept()
    return
  }
  const { study: kept, runs } = found
  await show(kept, runs)
}

/** A study of the shelf. */
async function show(kept: KeptStudy, runs: KeptRun[]): Promise<void> {
  phase.value = 'opening'
  const desk = new Desk(kept.document, tell, trouble)
  try {
    await desk.open()
    await begin(kept, desk, runs, { isNew: false })
  } catch (error) {
    desk.close()
    phase.value = study.peek() ? 'paused' : 'idle'
    throw error
  }
}

async function begin(
  kept: KeptStudy,
  desk: Desk,
  runs: KeptRun[],
  { workers, isNew }: { workers?: number | undefined; isNew: boolean },
): Promise<void> {
  leave()
  for (const run of runs) desk.keep(run)
  const { question, maps, recorded = null } = documentOf(kept.document)
  const { id, title, document, firstSeeds } = kept
  const now: Study = {
    id,
    title,
    document,
    question,
    maps,
    recorded,
    runs: kept.runs,
    firstSeeds,
    elsewhere: false,
  }
  const keeper = new Keeper(kept, refused)
  const runner: Runner = new Runner({
    study: now,
    desk,
    keeper,
    kept: runs.length,
    workers,
    changed: () => mine === open && changed(mine),
    rested: () => mine === open && rest(mine),
  })
  const closed = new AbortController()
  const mine: Open = { study: now, kept, desk, runner, keeper, letGo: null, closed }
  kept.total = runner.progress.total
  if (isNew) for (const run of runs) keeper.keep(run)
  open = mine
  rememberInTab(STUDY_IN_TAB, id)
  batch(() => {
    study.value = now
    analysis.value = null
    analysisError.value = null
    verification.value = null
    failures.value = []
    finishing.value = 0
    settle(mine)
  })
  if (isNew) void keeper.flush()
  else if (await isTaken(id)) waitForOther(mine)
}

/** Nothing runs. */
function settle(mine: Open): void {
  progress.value = mine.runner.progress
  failures.value = firstOfEach(mine.runner.failures)
  finishing.value = 0
  phase.value = mine.runner.isComplete ? 'done' : 'paused'
  void mine.desk.look(true)
}

/** The last run under way has ended. */
export function rest(mine: Open): void {
  mine.runner.halt()
  batch(() => settle(mine))
  void mine.keeper.flush().then(() => {
    if (phase.peek() === 'running') return
    mine.letGo?.()
    mine.letGo = null
  })
}

export function changed(mine: Open): void {
  mine.desk.lookSoon()
  if (shown !== 0) return
  shown = window.setTimeout(() => {
    shown = 0
    if (mine !== open) return
    batch(() => {
      progress.value = mine.runner.progress
      failures.value = firstOfEach(mine.runner.failures)
      if (phase.peek() === 'paused') finishing.value = mine.runner.inFlight
    })
  }, SHOW_MS)
}

/** Another tab runs it: this one shows how far it was, and again once it is free. */
export function waitForOther(mine: Open): void {
  mine.study = { ...mine.study, elsewhere: true }
  study.value = mine.study
  void whenFree(mine.study.id, mine.closed.signal).then(() => {
    if (mine === open) openStudy(mine.study.id).catch(notifyError)
  })
}

/** Another tab may have run it since it was opened here. */
export async function takeInFromOthers(mine: Open): Promise<void> {
  const found = await keptStudy(mine.study.id).catch(() => null)
  for (const run of found?.runs ?? []) if (!mine.desk.has(run.index)) mine.desk.keep(run)
  if (found) mine.kept.done = Math.max(mine.kept.done, found.runs.length)
  mine.runner.recount()
}

/** Nothing is open any more; what runs is stopped. */
export function closeStudy(): void {
  leave()
  rememberInTab(STUDY_IN_TAB, null)
  batch(() => {
    study.value = null
    phase.value = 'idle'
    progress.value = NO_PROGRESS
    analysis.value = null
    analysisError.value = null
    verification.value = null
    failures.value = []
    finishing.value = 0
  })
  void refreshKept()
}

function leave(): void {
  if (!open) return
  const { runner, desk, keeper, letGo, closed } = open
  open = null
  runner.end()
  desk.close()
  closed.abort()
  void keeper.flush().then(letGo ?? undefined)
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

/** Told once: runs go on all the same. */
function refused(error: unknown): void {
  const isFull = error instanceof DOMException && error.name === 'QuotaExceededError'
  notify('warning', t(isFull ? 'lab.kept.full' : 'lab.kept.refused'), {
    hint: t('lab.kept.refusedHint'),
  })
}

/** Hundreds of runs of one entry fail for one reason. */
function firstOfEach(all: typeof failures.value): typeof failures.value {
  const seen = new Set<string>()
  return all.filter(({ error }) => {
    const isNew = !seen.has(error.message)
    seen.add(error.message)
    return isNew
  })
}

function withoutRows({ rows: _, ...document }: LabDocument): LabDocument {
  return document
}

// Another axis is another look at the same runs.
effect(() => {
  axis.value
  void open?.desk.look(phase.peek() !== 'running')
})
