/** Experiments and their runs, kept by the browser: a closed tab loses no more than what came in the last moment. */
import { type DBSchema, type IDBPDatabase, openDB } from 'idb'
import type { KeptRun } from './analyst'

/** What is kept of an experiment beside its runs. */
export interface KeptStudy {
  id: string
  title: string
  /** `formicarium/comparison@1` without its runs. */
  document: string
  runs: 'own' | 'file'
  firstSeeds: number | null
  /** Milliseconds since 1970. */
  created: number
  /** Runs that are done, and to be done altogether. */
  done: number
  total: number
}

interface Shelf extends DBSchema {
  studies: { key: string; value: KeptStudy }
  rows: { key: [study: string, index: number]; value: KeptRun }
}

const NAME = 'formicarium.lab'
/** One transaction for all runs of this time: a thousand small ones would hold up the page. */
const BATCH_MS = 200

let opening: Promise<IDBPDatabase<Shelf>> | null = null

function shelf(): Promise<IDBPDatabase<Shelf>> {
  opening ??= openDB<Shelf>(NAME, 1, {
    upgrade(database) {
      database.createObjectStore('studies', { keyPath: 'id' })
      database.createObjectStore('rows')
    },
    // A newer version of the page in another tab must not wait for this one.
    blocking: () => forget(),
    terminated: () => forget(),
  }).catch((error: unknown) => {
    opening = null
    throw error
  })
  return opening
}

function forget(): void {
  void opening?.then((database) => database.close())
  opening = null
}

/** The newest first. */
export async function keptStudies(): Promise<KeptStudy[]> {
  const all = await (await shelf()).getAll('studies')
  return all.sort((a, b) => b.created - a.created)
}

export async function keptStudy(id: string): Promise<{ study: KeptStudy; runs: KeptRun[] } | null> {
  const database = await shelf()
  const [study, runs] = await Promise.all([
    database.get('studies', id),
    database.getAll('rows', rowsOf(id)),
  ])
  return study ? { study, runs } : null
}

export async function forgetStudy(id: string): Promise<void> {
  const change = (await shelf()).transaction(['studies', 'rows'], 'readwrite')
  await Promise.all([
    change.objectStore('studies').delete(id),
    change.objectStore('rows').delete(rowsOf(id)),
    change.done,
  ])
}

/** Every index of a study: arrays come after all numbers. */
const rowsOf = (id: string) => IDBKeyRange.bound([id], [id, []])

/** Writes down a study and its runs as they come. `trouble` is told when the browser refuses; nothing is written afterwards. */
export class Keeper {
  private waiting: KeptRun[] = []
  private timer = 0
  private writing: Promise<void> = Promise.resolve()
  private refused = false

  constructor(
    private readonly study: KeptStudy,
    private readonly trouble: (error: unknown) => void,
  ) {}

  /** The study itself, before any run. */
  begin(): Promise<void> {
    return this.flush()
  }

  keep(run: KeptRun): void {
    this.study.done += 1
    this.waiting.push(run)
    if (this.timer === 0) this.timer = window.setTimeout(() => void this.flush(), BATCH_MS)
  }

  /** Resolves when all that has been given is on the shelf. */
  flush(): Promise<void> {
    clearTimeout(this.timer)
    this.timer = 0
    const runs = this.waiting
    this.waiting = []
    this.writing = this.writing.then(() => this.write(runs, { ...this.study }))
    return this.writing
  }

  private async write(runs: KeptRun[], study: KeptStudy): Promise<void> {
    if (this.refused) return
    try {
      await putStudy(study, runs)
    } catch (error) {
      this.refused = true
      this.trouble(error)
    }
  }
}

/** A study as it stands, and some of its runs. */
export async function putStudy(study: KeptStudy, runs: KeptRun[]): Promise<void> {
  const change = (await shelf()).transaction(['studies', 'rows'], 'readwrite')
  const rows = change.objectStore('rows')
  await Promise.all([
    change.objectStore('studies').put(study),
    ...runs.map((run) => rows.put(run, [study.id, run.index])),
    change.done,
  ])
}
