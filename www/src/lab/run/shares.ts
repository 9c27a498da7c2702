/** What a class does with the open comparison: its runs in shares. */
import { type ShareOfClass, shareText } from '../../share/share_of_class'
import type { BroughtFile } from '../store/browser_storage'
import { fileStem } from '../store/names'
import { workOf } from './estimate'
import { amend, openParts, refresh } from './open_comparison'
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
