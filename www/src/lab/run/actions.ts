/** The laboratory's actions: what is open, what runs, what is kept. idle → opening → running ⇄ paused → done. */
import type { ReportLanguage, ResultFile } from '@pkg/formicarium'
import { batch } from '@preact/signals'
import { lateTools } from '../../engine/late_tools'
import { translated } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Analysis, FrontQuestion, MapFronts } from '../../model/analysis'
import type { KeptRun } from '../../model/comparison_calls'
import { canKeep } from '../../model/storage'
import type { ToldByLink } from '../../share/comparison_link'
import type { ShareOfClass } from '../../share/share_of_class'
import { notify, notifyError } from '../../state'
import { deleteComparison, storedComparison } from '../store/browser_storage'
import { refreshKeptComparisons, removeKeptComparison } from '../store/kept_comparisons'
import { fileStem } from '../store/names'
import {
  failures,
  finishing,
  type OpenComparison,
  openComparison,
  phase,
  verification,
} from '../store/signals'
import { lockComparison } from '../store/tab_lock'
import { COMPARISON_IN_TAB, recallInTab } from '../store/tab_memory'
import { dropUnstored, noteUnstored } from '../store/unstored'
import {
  changed,
  closeComparison,
  comeToRest,
  openKeptComparison,
  openNew,
  openParts,
  takeInFromOthers,
  waitForOther,
} from './open_comparison'
import { timesCsv } from './times_csv'

export * from '../../model/comparison'
export { refreshKeptComparisons } from '../store/kept_comparisons'
export * from '../store/signals'
export { closeComparison, openKeptComparison } from './open_comparison'

/** How a file is written. */
export interface HowWritten {
  /** Of what people read; CSV and JSON are the same in each. */
  language?: ReportLanguage
  /** What files of fronts trade off; length and turns, if nothing is said. */
  fronts?: FrontQuestion
  /** How the file says that it was made. */
  command?: string
}

export interface StartOptions {
  /** Only this many seeds of each entry, the first ones. */
  firstSeeds?: number | null
  /** As many as the machine has processors, if nothing is said. */
  workers?: number
  /** The share of a class to be done; all runs, if nothing is said. */
  share?: ShareOfClass | null
}

/** Opens a document as a new comparison and runs it. Rejects with the engine's typed error when the engine refuses the document. */
export async function startComparison(document: string, options: StartOptions = {}): Promise<void> {
  const { firstSeeds = null, workers, share = null } = options
  await openNew({ document, runs: 'own', firstSeeds, workers, share })
  await goOn()
}

/** Opens a document: shows the runs in it; those that are missing can be run. `told`: what a link tells beside it. */
export async function openDocument(text: string, told?: ToldByLink): Promise<void> {
  await openNew({ document: text, runs: 'file', firstSeeds: null, ...told })
}

/** Runs the open comparison once more, as a new one, to see whether the same comes out. */
export async function runAgain(options: StartOptions = {}): Promise<void> {
  const now = openComparison.peek()
  if (now) await startComparison(now.document, { ...options, share: now.share })
}

/** Opens the comparison anew, as another one, with imported results beside its runs. Rejects with the engine's typed error. */
export async function joinResults(
  name: string,
  bytes: Uint8Array,
  instance: string | null,
  leaveOut: string[],
): Promise<void> {
  const mine = openParts()
  if (!mine) return
  pause()
  const document = await lateTools.joinResults(
    mine.comparison.document,
    bytes,
    name,
    instance,
    leaveOut,
  )
  // Imported entries come last, so that every other run keeps its place. What a link told was of the question without them.
  // A share is one of the question without them.
  const { share: _, ...stored } = mine.stored
  await openNew({ ...stored, document, done: mine.analyst.all, numbers: null })
}

/** Whether it waits for somebody to say whose share is to be done. */
const isUnchosen = ({ share }: OpenComparison) => share !== null && share.index === null

/** Starts no more runs; those under way are finished and kept. */
export function pause(): void {
  const mine = openParts()
  if (!mine || phase.peek() !== 'running') return
  mine.runner.halt()
  phase.value = 'paused'
  if (mine.runner.inFlight === 0) comeToRest(mine)
  else finishing.value = mine.runner.inFlight
}

/** Does the runs that are missing, unless another tab is doing them. */
export async function goOn(): Promise<void> {
  const mine = openParts()
  if (!mine || phase.peek() === 'running' || isUnchosen(mine.comparison)) return
  if (mine.unlock === null) {
    mine.unlock = await lockComparison(mine.comparison.id)
    if (mine !== openParts()) return mine.unlock?.()
    if (mine.unlock === null) return waitForOther(mine)
    await takeInFromOthers(mine)
    if (mine !== openParts()) return
  }
  if (!canKeep()) noteUnstored(mine.comparison.id)
  batch(() => {
    phase.value = 'running'
    finishing.value = 0
    failures.value = []
  })
  mine.runner.start()
  changed(mine)
}

/** Ends the runs at once; a comparison with finished runs is kept. */
export async function cancel(): Promise<void> {
  const mine = openParts()
  if (!mine) return
  mine.runner.end()
  const { done } = mine.runner.progress
  await mine.writer.flush()
  if (done > 0) tellStopped()
  closeComparison()
  if (done === 0) await forget(mine.comparison.id)
  await refreshKeptComparisons()
}

/** Says that the runs are ended and those that are done are kept, with a way back. */
export function tellStopped(): void {
  const mine = openParts()
  if (!mine) return
  const { id, title } = mine.comparison
  const count = mine.runner.progress.done
  notify('info', t('lab.run.stopped', { title: translated(title), count }), {
    hint: t('lab.run.stoppedHint'),
    action: {
      label: t('lab.kept.open'),
      run: () => void openKeptComparison(id).catch(notifyError),
    },
  })
}

async function forget(id: string): Promise<void> {
  dropUnstored(id)
  await deleteComparison(id).catch(() => {})
}

export async function removeComparison(id: string): Promise<void> {
  if (openParts()?.comparison.id === id) closeComparison()
  dropUnstored(id)
  await removeKeptComparison(id)
}

/** A result file of the runs that are done, as the command line writes it; in English unless another language is asked for. */
export function resultFile(
  kind: ResultFile,
  { language = 'en', fronts, command = commandOf(language, fronts) }: HowWritten = {},
): Promise<string> {
  return openParts()?.analyst.file(kind, command, language, fronts) ?? Promise.resolve('')
}

/** What the runs that are done trade off; null where nothing is open. Rejects with the engine's typed error. */
export async function frontsNow(asked: FrontQuestion): Promise<MapFronts[] | null> {
  return (await openParts()?.analyst.fronts(asked)) ?? null
}

/** What the runs that are done say now, without intervals; null where nothing is open. */
export async function analysisNow(): Promise<Analysis | null> {
  return (await openParts()?.analyst.analysis()) ?? null
}

/** A file of how long the runs took that were done in this browser. */
export function timesFile(): string {
  const mine = openParts()
  return mine ? timesCsv(mine.comparison.question, mine.analyst.kept()) : ''
}

/** The numbers of the runs in the order in which they are handed out; see `Tasks`. */
export function runsInOrder(seeds: number | null): number[] {
  return openParts()?.tasks.inOrder(seeds) ?? []
}

/** Takes in a repeated run, only to compare it with the recorded one. */
export function checkRun(run: KeptRun): void {
  openParts()?.analyst.check(run)
}

/** Compares repeated runs with the recorded ones. */
export async function compareAgain(): Promise<void> {
  const mine = openParts()
  const told = await mine?.analyst.verify()
  if (mine && mine === openParts()) verification.value = told ?? null
}

/** Opens what this tab had open before a reload. */
export async function reopenInTab(): Promise<void> {
  const id = recallInTab(COMPARISON_IN_TAB)
  if (id !== null && (await storedComparison(id).catch(() => null))) await openKeptComparison(id)
}

/** The command that makes the same files; what it asks of itself need not be named. */
function commandOf(language: ReportLanguage, fronts?: FrontQuestion): string {
  const open = openComparison.peek()
  const command = `formicarium compare ${fileStem(open?.title ?? '')}.json --out DIR`
  const usual = open?.outline.fronts.measures.join()
  const isOther = fronts !== undefined && fronts.measures.join() !== usual
  const measures = isOther ? ` --fronts ${fronts.measures.join()}` : ''
  const reference = fronts?.reference ? ` --fronts-reference ${fronts.reference.join()}` : ''
  return `${command}${measures}${reference}${language === 'en' ? '' : ` --language ${language}`}`
}
