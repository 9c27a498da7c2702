/** Experiments and their runs, kept by the browser: a closed tab loses no more than what came in the last moment. */
import { type DBSchema, type IDBPDatabase, openDB } from 'idb'
import type { KeptRun } from '../../model/comparison_calls'
import type { KeptDraft } from '../../model/draft'

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

/** Drafts of tabs that were closed are of no use for long. */
const DRAFT_MS = 7 * 24 * 3600 * 1000

interface Shelf extends DBSchema {
  studies: { key: string; value: KeptStudy }
  rows: { key: [study: string, index: number]; value: KeptRun }
  drafts: { key: string; value: KeptDraft; indexes: { changed: number } }
}

const NAME = 'formicarium.lab'
let opening: Promise<IDBPDatabase<Shelf>> | null = null

function shelf(): Promise<IDBPDatabase<Shelf>> {
  opening ??= openDB<Shelf>(NAME, 2, {
    upgrade(database, from) {
      if (from < 1) {
        database.createObjectStore('studies', { keyPath: 'id' })
        database.createObjectStore('rows')
      }
      database.createObjectStore('drafts').createIndex('changed', 'changed')
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

/** The newest first. Of one that was broken off, its runs tell how far it got. */
export async function keptStudies(): Promise<KeptStudy[]> {
  const database = await shelf()
  const all = await database.getAll('studies')
  const counted = all.map(async (study) => {
    if (study.done >= study.total) return study
    return { ...study, done: await database.count('rows', rowsOf(study.id)) }
  })
  return (await Promise.all(counted)).sort((a, b) => b.created - a.created)
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

/**
 * Writes down a study, and its runs as they come: at once, and those that come while others are being written all together after them. A
 * tab may be closed at any moment. `trouble` is told when the browser refuses; nothing is written afterwards.
 */
export class Keeper {
  private waiting: KeptRun[] = []
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
    if (this.waiting.length === 1) this.next((runs) => putRuns(this.study.id, runs))
  }

  /** Resolves when all that has been given is on the shelf, and the study says so. */
  flush(): Promise<void> {
    return this.next((runs) => putStudy({ ...this.study }, runs))
  }

  private next(put: (runs: KeptRun[]) => Promise<void>): Promise<void> {
    this.writing = this.writing.then(async () => {
      const runs = this.waiting
      this.waiting = []
      if (!this.refused) await put(runs).catch((error: unknown) => this.refuse(error))
    })
    return this.writing
  }

  private refuse(error: unknown): void {
    this.refused = true
    this.trouble(error)
  }
}

async function putRuns(study: string, runs: KeptRun[]): Promise<void> {
  const change = (await shelf()).transaction('rows', 'readwrite')
  await Promise.all([...runs.map((run) => change.store.put(run, [study, run.index])), change.done])
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

export async function keptDraft(id: string): Promise<KeptDraft | null> {
  return (await (await shelf()).get('drafts', id)) ?? null
}

/** Takes the place of what was kept of it, and makes room where others have been left. */
export async function putDraft(id: string, draft: KeptDraft): Promise<void> {
  const change = (await shelf()).transaction('drafts', 'readwrite')
  const left = IDBKeyRange.upperBound(draft.changed - DRAFT_MS)
  const old = await change.store.index('changed').getAllKeys(left)
  await Promise.all([
    ...old.map((key) => change.store.delete(key)),
    change.store.put(draft, id),
    change.done,
  ])
}
