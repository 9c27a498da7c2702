/** Journals of others: taken into the open comparison, and out of it again. */
import type { JournalFault, TakenJournal } from '@pkg/formicarium'
import { t } from '../../i18n/lab'
import { notify, notifyError } from '../../state'
import type { UnreadFile } from '../../state/file_bytes'
import type { BroughtFile } from '../store/browser_storage'
import { noteRefusal, type RefusedJournal } from '../store/refused_journals'
import { newAnalyst } from './analyst'
import { amend, type OpenParts, openParts, refresh } from './open_comparison'
import { placedRun } from './shares'

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

function keep({ analyst, writer }: OpenParts, index: number): void {
  const run = analyst.get(index)
  if (run) writer.keep(run)
}

const nextKey = ({ comparison }: OpenParts): number =>
  Math.max(0, ...comparison.brought.map(({ key }) => key)) + 1

async function tellWhatItNeeds(name: string, bytes: Uint8Array): Promise<undefined> {
  const analyst = newAnalyst()
  const digest = await analyst.call('digestIn', bytes).finally(() => analyst.terminate())
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
