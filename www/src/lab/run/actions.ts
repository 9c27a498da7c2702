/** The laboratory's actions: what is open, what runs, what is kept. idle → opening → running ⇄ paused → done. */
import type { ResultFile } from '@pkg/formicarium'
import { batch } from '@preact/signals'
import { tools } from '../../engine/tools'
import { translated } from '../../i18n'
import { t } from '../../i18n/lab'
import type { KeptRun } from '../../model/comparison_calls'
import { notify, notifyError } from '../../state'
import { recallInTab, refreshKept, removeKept, STUDY_IN_TAB } from '../store/kept'
import { fileStem } from '../store/names'
import { forgetStudy, keptStudy } from '../store/shelf'
import { failures, finishing, phase, study, verification } from '../store/signals'
import { takeAlone } from '../store/tab_lock'
import {
  changed,
  closeStudy,
  opened,
  openStudy,
  rest,
  take,
  takeInFromOthers,
  waitForOther,
} from './opened'
import { timesCsv } from './times'

export * from '../../model/comparison'
export { refreshKept } from '../store/kept'
export * from '../store/signals'
export { closeStudy, openStudy } from './opened'

export interface StartOptions {
  /** Only the first so many seeds of each entry. */
  firstSeeds?: number | null
  /** As many as the machine has processors, if nothing is said. */
  workers?: number
}

/** Runs an experiment in a study of its own. Rejects with the engine's typed error when it cannot be asked. */
export async function startStudy(document: string, options: StartOptions = {}): Promise<void> {
  const { firstSeeds = null, workers } = options
  await take({ document, runs: 'own', firstSeeds, workers })
  await goOn()
}

/** Opens a document: the runs in it are shown, what is left of them can be run. */
export async function openDocument(text: string): Promise<void> {
  await take({ document: text, runs: 'file', firstSeeds: null })
}

/** Once more, in a study of its own: whether the same comes out. */
export async function runAgain(options: StartOptions = {}): Promise<void> {
  const now = study.peek()
  if (now) await startStudy(now.document, options)
}

/** The open experiment with somebody's own results beside its runs, in a study of its own. Rejects with the engine's typed error. */
export async function joinResults(
  name: string,
  bytes: Uint8Array,
  instance: string | null,
): Promise<void> {
  const mine = opened()
  if (!mine) return
  pause()
  const document = await tools.joinResults(mine.study.document, bytes, name, instance)
  // Entries that are not run come last and change no other run's place.
  await take({ ...mine.kept, document, done: mine.desk.all })
}

/** Runs under way are finished and kept. */
export function pause(): void {
  const mine = opened()
  if (!mine || phase.peek() !== 'running') return
  mine.runner.halt()
  phase.value = 'paused'
  if (mine.runner.inFlight === 0) rest(mine)
  else finishing.value = mine.runner.inFlight
}

/** Runs what is left, unless another tab does. */
export async function goOn(): Promise<void> {
  const mine = opened()
  if (!mine || phase.peek() === 'running') return
  if (mine.letGo === null) {
    mine.letGo = await takeAlone(mine.study.id)
    if (mine !== opened()) return mine.letGo?.()
    if (mine.letGo === null) return waitForOther(mine)
    await takeInFromOthers(mine)
    if (mine !== opened()) return
  }
  batch(() => {
    phase.value = 'running'
    finishing.value = 0
    failures.value = []
  })
  mine.runner.start()
  changed(mine)
}

/** Ends the runs at once; what is finished stays as a study. */
export async function cancel(): Promise<void> {
  const mine = opened()
  if (!mine) return
  mine.runner.end()
  const { done } = mine.runner.progress
  await mine.keeper.flush()
  const { id, title } = mine.study
  closeStudy()
  if (done === 0) await forgetStudy(id).catch(() => {})
  else
    notify('info', t('lab.run.stopped', { title: translated(title), count: done }), {
      hint: t('lab.run.stoppedHint'),
      action: { label: t('lab.kept.open'), run: () => void openStudy(id).catch(notifyError) },
    })
  await refreshKept()
}

export async function removeStudy(id: string): Promise<void> {
  if (opened()?.study.id === id) closeStudy()
  await removeKept(id)
}

/** One of the result files of the runs that are done, as the command line writes it. */
export function resultFile(kind: ResultFile, command = commandOf()): Promise<string> {
  return opened()?.desk.file(kind, command) ?? Promise.resolve('')
}

/** How long the runs took that were done in this browser. */
export function timesFile(): string {
  const mine = opened()
  return mine ? timesCsv(mine.study.question, mine.desk.kept()) : ''
}

/** Takes in a run that was done again, only to be compared with the one that the document brought. */
export function checkRun(run: KeptRun): void {
  opened()?.desk.check(run)
}

/** Compares once more. */
export async function compareAgain(): Promise<void> {
  const mine = opened()
  const told = await mine?.desk.verify()
  if (mine && mine === opened()) verification.value = told ?? null
}

/** What this tab had open before a reload. */
export async function reopenInTab(): Promise<void> {
  const id = recallInTab(STUDY_IN_TAB)
  if (id !== null && (await keptStudy(id).catch(() => null))) await openStudy(id)
}

/** How the same files come from the command line. */
function commandOf(): string {
  return `formicarium compare ${fileStem(study.peek()?.title ?? '')}.json --out DIR`
}
