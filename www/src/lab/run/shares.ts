/** What a class does with the open comparison: shares of its runs, and the files that bring them together. */
import type { JournalFault, TakenJournal } from '@pkg/formicarium'
import { tools } from '../../engine/tools'
import { t } from '../../i18n/lab'
import { type ShareOfClass, shareText } from '../../share/share_of_class'
import { notify, notifyError } from '../../state'
import type { UnreadFile } from '../../state/file_bytes'
import type { BroughtFile } from '../store/browser_storage'
import { fileStem } from '../store/names'
import { noteRefusal, type RefusedJournal } from '../store/refused_journals'
import { workOf } from './estimate'
import { amend, type OpenParts, openParts, refresh } from './open_comparison'
import { poolSize } from './pool'

/** Does only this share from now on; null: all runs. Throws where the engine knows no such share. */
export async function chooseShare(share: ShareOfClass | null): Promise<void> {
  const mine = openParts()
  if (!mine) return
  const tasks = share?.index == null ? null : await mine.analyst.dealt(shareText(share))
  if (mine !== openParts()) return
  mine.runner.restrict(tasks)
  refresh(mine)
  await amend(mine, { share })
}

/** The journal of the share that is done here, and the name of its file. */
export async function journalOfShare(): Promise<{ name: string; text: string } | null> {
  const mine = openParts()
  const share = mine?.comparison.share
  if (!mine || !share) return null
  const { name, text } = await mine.analyst.journal(shareText(share))
  return { name: `${fileStem(mine.comparison.title)}.${name}.journal`, text }
}

/** How many runs each of so many shares has at most, and seconds for it on a machine like this; null where nothing was timed here. */
export function sizeOfShares(of: number): { runs: number; seconds: number | null } {
  const mine = openParts()
  if (!mine) return { runs: 0, seconds: null }
  const all = mine.tasks.inOrder()
  const runs = Math.ceil(all.length / of)
  const work = workOf(mine.tasks, all, mine.analyst.kept())
  return { runs, seconds: work === null ? null : work / of / poolSize(runs) }
}

/** Notes to how many shares the runs were dealt, so that the missing ones are told. */
export async function dealTo(of: number): Promise<void> {
  const mine = openParts()
  if (mine && mine.comparison.dealt !== of) await amend(mine, { dealt: of })
}

/** How far a share is. */
export interface ShareState {
  share: number
  runs: number
  done: number
  /** Files that say to be this share. */
  files: BroughtFile[]
}

/** Of each run the number of its share, where there are so many. */
export const sharesOfRuns = (of: number): Promise<Uint32Array> =>
  openParts()?.analyst.shares(of) ?? Promise.resolve(new Uint32Array())

/** How far each of so many shares is; `numbers`: of each run its share. */
export function statesOfShares(of: number, numbers: Uint32Array): ShareState[] {
  const mine = openParts()
  if (!mine) return []
  const states = Array.from({ length: of }, (_, at): ShareState => {
    const share = at + 1
    const text = shareText({ index: share, of })
    const files = mine.comparison.brought.filter((file) => file.share === text)
    return { share, runs: 0, done: 0, files }
  })
  for (const [task, share] of numbers.entries()) {
    const state = states[share - 1]
    if (!state) continue
    state.runs += 1
    if (mine.analyst.has(task)) state.done += 1
  }
  return states
}

/** Files are taken in one after the other, however many come at once. */
let turn: Promise<void> = Promise.resolve()

/** Takes journals, each of them whole, or notes by its name why not. */
export function takeJournals(files: UnreadFile[]): Promise<void> {
  turn = turn.then(async () => {
    const taken: BroughtFile[] = []
    const refused: string[] = []
    for (const { name, read } of files) {
      try {
        const file = await takeJournal(name, await read())
        if (file === 'refused') refused.push(name)
        else if (file) taken.push(file)
      } catch (error) {
        notifyError(error)
      }
    }
    tellTaken(taken, refused)
  })
  return turn
}

function tellTaken(taken: BroughtFile[], refused: string[]): void {
  const count = taken.reduce((sum, { runs }) => sum + runs, 0)
  const [first] = taken
  if (first && taken.length === 1)
    notify('success', t('lab.class.taken', { name: first.name, count }))
  else if (first) notify('success', t('lab.class.takenAll', { files: taken.length, count }))
  const hint = t('lab.class.refusedHint')
  if (refused.length === 1)
    notify('warning', t('lab.class.refused', { name: refused[0] }), { hint })
  else if (refused.length > 1)
    notify('warning', t('lab.class.refusedAll', { count: refused.length }), { hint })
}

/** The file as it is kept; nothing where no comparison is open. */
async function takeJournal(
  name: string,
  bytes: Uint8Array,
): Promise<BroughtFile | 'refused' | undefined> {
  const mine = openParts()
  if (!mine) return tellWhatItNeeds(name, bytes)
  const key = nextKey(mine)
  const taken = await mine.analyst.takeJournal(new TextDecoder().decode(bytes), key)
  if (mine !== openParts()) return undefined
  if (taken.fault_count > 0 || taken.unlike_count > 0) {
    noteRefusal(refusalOf(mine, name, taken))
    return 'refused'
  }
  const file: BroughtFile = {
    key,
    name,
    share: taken.shard,
    runs: taken.runs.length,
    same: taken.same + taken.new - taken.runs.length,
    isCut: taken.is_cut,
  }
  for (const { index } of taken.runs) keep(mine, index)
  mine.runner.recount()
  refresh(mine)
  await amend(mine, { brought: [...mine.comparison.brought, file] })
  return file
}

/** Lets go of a file, and of the runs that it has brought. */
export async function removeBrought(key: number): Promise<void> {
  const mine = openParts()
  if (!mine) return
  const indices = mine.analyst.all.filter(({ from }) => from === key).map(({ index }) => index)
  await mine.analyst.forget(indices)
  await mine.writer.forget(indices)
  mine.runner.recount()
  refresh(mine)
  await amend(mine, { brought: mine.comparison.brought.filter((file) => file.key !== key) })
}

/** Places of runs that files have brought, by the keys of the files. */
export function broughtRuns(): Map<number, number[]> {
  const byFile = new Map<number, number[]>()
  for (const { index, from } of openParts()?.analyst.kept() ?? []) {
    if (from === undefined) continue
    const runs = byFile.get(from) ?? []
    byFile.set(from, runs)
    runs.push(index)
  }
  return byFile
}

/** A run by its place: where it stands in the question, what it says, and which file has brought it. */
export interface PlacedRun {
  instance: number
  entry: number
  seed: number
  row: string
  from: number | null
}

export function placedRun(index: number): PlacedRun | null {
  const mine = openParts()
  const run = mine?.analyst.get(index)
  if (!mine || !run) return null
  const { tasks } = mine
  return {
    instance: tasks.instanceOf(index),
    entry: tasks.entryOf(index),
    seed: tasks.seedOf(index),
    row: run.row,
    from: run.from ?? null,
  }
}

/** Runs of the whole question, whatever part of it is to be done here, and those that are there. */
export function runsOfQuestion(): { all: number; there: number } {
  const mine = openParts()
  return { all: mine?.tasks.inOrder().length ?? 0, there: mine?.analyst.count ?? 0 }
}

function keep({ analyst, writer }: OpenParts, index: number): void {
  const run = analyst.get(index)
  if (run) writer.keep(run)
}

const nextKey = ({ comparison }: OpenParts): number =>
  Math.max(0, ...comparison.brought.map(({ key }) => key)) + 1

async function tellWhatItNeeds(name: string, bytes: Uint8Array): Promise<undefined> {
  const digest = await tools.journalDigest(bytes)
  const says = digest
    ? t('lab.class.needs', { name, digest })
    : t('lab.class.needsUnknown', { name })
  notify('warning', says, { hint: t('lab.class.needsHint') })
}

function refusalOf(
  mine: OpenParts,
  name: string,
  taken: TakenJournal,
): Omit<RefusedJournal, 'key'> {
  const names = new Map(mine.comparison.brought.map((file) => [file.key, file.name]))
  const unlike = taken.unlike.flatMap((index) => {
    const run = placedRun(index)
    // Two lines of the file itself disagree where nobody else has brought the run.
    const by = run === null ? name : run.from === null ? null : (names.get(run.from) ?? null)
    return {
      instance: mine.tasks.instanceOf(index),
      entry: mine.tasks.entryOf(index),
      seed: mine.tasks.seedOf(index),
      by,
    }
  })
  const faults: { line: number; fault: JournalFault }[] = taken.faults
  const more = taken.fault_count + taken.unlike_count - faults.length - unlike.length
  return { name, faults, unlike, more }
}
