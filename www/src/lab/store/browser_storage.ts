/** The browser's storage for comparisons, their runs and drafts (IndexedDB). A closed tab loses only the runs of the last moment. */
import { type DBSchema, type IDBPDatabase, openDB } from 'idb'
import type { KeptRun } from '../../model/comparison_calls'
import type { StoredDraft } from '../../model/draft'
import { canKeep } from '../../model/storage'
import type { NumbersOfLink } from '../../share/recorded_numbers'

/** A comparison as it is stored, without its runs. */
export interface StoredComparison {
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
  /** What the link that it came in tells of its runs. */
  numbers?: NumbersOfLink
  /** The share of a class that is done here, as in a link (share/share_of_class.ts). */
  share?: string
  /** To how many shares it was dealt here. */
  dealt?: number
  /** Files of others that have brought runs. */
  brought?: BroughtFile[]
}

/** A journal that was taken in. */
export interface BroughtFile {
  /** Its runs carry it. */
  key: number
  name: string
  /** Whose runs it has, as `I/N`; null where it does not say. */
  share: string | null
  /** Runs that it has brought, and those that were there already. */
  runs: number
  same: number
  /** It ends in the middle of a line. */
  isCut: boolean
}

/** Drafts of closed tabs are deleted after this time. */
const DRAFT_MS = 7 * 24 * 3600 * 1000

interface LabDatabase extends DBSchema {
  studies: { key: string; value: StoredComparison }
  rows: { key: [comparison: string, index: number]; value: KeptRun }
  drafts: { key: string; value: StoredDraft; indexes: { changed: number } }
}

const NAME = 'formicarium.lab'
let opening: Promise<IDBPDatabase<LabDatabase>> | null = null

async function openDatabase(): Promise<IDBPDatabase<LabDatabase>> {
  if (!canKeep()) throw new DOMException('this page keeps nothing', 'SecurityError')
  opening ??= openDB<LabDatabase>(NAME, 2, {
    upgrade(database, from) {
      if (from < 1) {
        database.createObjectStore('studies', { keyPath: 'id' })
        database.createObjectStore('rows')
      }
      database.createObjectStore('drafts').createIndex('changed', 'changed')
    },
    // A newer version of the page in another tab must not wait for this tab.
    blocking: () => closeDatabase(),
    terminated: () => closeDatabase(),
  }).catch((error: unknown) => {
    opening = null
    throw error
  })
  return opening
}

function closeDatabase(): void {
  void opening?.then((database) => database.close()).catch(() => {})
  opening = null
}

/** Newest first. How far an interrupted one got is counted from its runs. */
export async function storedComparisons(): Promise<StoredComparison[]> {
  const database = await openDatabase()
  const all = await database.getAll('studies')
  const counted = all.map(async (comparison) => {
    if (comparison.done >= comparison.total) return comparison
    return { ...comparison, done: await database.count('rows', rowsOf(comparison.id)) }
  })
  return (await Promise.all(counted)).sort((a, b) => b.created - a.created)
}

export async function storedComparison(
  id: string,
): Promise<{ comparison: StoredComparison; runs: KeptRun[] } | null> {
  const database = await openDatabase()
  const [comparison, runs] = await Promise.all([
    database.get('studies', id),
    database.getAll('rows', rowsOf(id)),
  ])
  return comparison ? { comparison, runs } : null
}

export async function deleteComparison(id: string): Promise<void> {
  const change = (await openDatabase()).transaction(['studies', 'rows'], 'readwrite')
  await Promise.all([
    change.objectStore('studies').delete(id),
    change.objectStore('rows').delete(rowsOf(id)),
    change.done,
  ])
}

/** The keys of all runs of a comparison: in IndexedDB an array is greater than any number. */
const rowsOf = (id: string) => IDBKeyRange.bound([id], [id, []])

/**
 * Stores a comparison and its runs as they come. A tab may be closed at any moment, so a run is written at once; runs that come during
 * a write are written together after it. When the browser refuses, `trouble` is called and nothing more is written.
 */
export class ComparisonWriter {
  private waiting: KeptRun[] = []
  private writing: Promise<void> = Promise.resolve()
  /** Whether runs are no longer written. */
  hasRefused = false

  constructor(
    private readonly comparison: StoredComparison,
    private readonly trouble: (error: unknown) => void,
  ) {}

  /** The comparison itself, before any run. */
  begin(): Promise<void> {
    return this.flush()
  }

  keep(run: KeptRun): void {
    this.comparison.done += 1
    this.waiting.push(run)
    if (this.waiting.length === 1) this.next((runs) => storeRuns(this.comparison.id, runs))
  }

  /** Lets go of runs that are stored, by their places. */
  forget(indices: number[]): Promise<void> {
    this.comparison.done -= indices.length
    const gone = new Set(indices)
    this.writing = this.writing.then(async () => {
      this.waiting = this.waiting.filter(({ index }) => !gone.has(index))
      await deleteRuns(this.comparison.id, indices).catch((error: unknown) => this.refuse(error))
    })
    return this.flush()
  }

  /** Resolves when all runs are stored, and the comparison with their number. */
  flush(): Promise<void> {
    return this.next((runs) => storeComparison({ ...this.comparison }, runs))
  }

  private next(put: (runs: KeptRun[]) => Promise<void>): Promise<void> {
    this.writing = this.writing.then(async () => {
      const runs = this.waiting
      this.waiting = []
      if (!this.hasRefused) await put(runs).catch((error: unknown) => this.refuse(error))
    })
    return this.writing
  }

  private refuse(error: unknown): void {
    this.hasRefused = true
    this.trouble(error)
  }
}

async function storeRuns(comparison: string, runs: KeptRun[]): Promise<void> {
  const change = (await openDatabase()).transaction('rows', 'readwrite')
  await Promise.all([
    ...runs.map((run) => change.store.put(run, [comparison, run.index])),
    change.done,
  ])
}

async function deleteRuns(comparison: string, indices: number[]): Promise<void> {
  const change = (await openDatabase()).transaction('rows', 'readwrite')
  await Promise.all([
    ...indices.map((index) => change.store.delete([comparison, index])),
    change.done,
  ])
}

/** Stores a comparison as it stands, with some of its runs. */
export async function storeComparison(
  comparison: StoredComparison,
  runs: KeptRun[],
): Promise<void> {
  const change = (await openDatabase()).transaction(['studies', 'rows'], 'readwrite')
  const rows = change.objectStore('rows')
  await Promise.all([
    change.objectStore('studies').put(comparison),
    ...runs.map((run) => rows.put(run, [comparison.id, run.index])),
    change.done,
  ])
}

export async function storedDraft(id: string): Promise<StoredDraft | null> {
  return (await (await openDatabase()).get('drafts', id)) ?? null
}

/** Replaces the stored draft, and deletes old drafts of other tabs. */
export async function storeDraft(id: string, draft: StoredDraft): Promise<void> {
  const change = (await openDatabase()).transaction('drafts', 'readwrite')
  const stored = change.store.put(draft, id)
  // Said at once: a page that is being left does not hear that it was put, and the browser would take it back.
  change.commit()
  await Promise.all([stored, change.done])
  await deleteOldDrafts(draft.changed - DRAFT_MS)
}

async function deleteOldDrafts(before: number): Promise<void> {
  const change = (await openDatabase()).transaction('drafts', 'readwrite')
  const old = await change.store.index('changed').getAllKeys(IDBKeyRange.upperBound(before))
  await Promise.all([...old.map((key) => change.store.delete(key)), change.done])
}
