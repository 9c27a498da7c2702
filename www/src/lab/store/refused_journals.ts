/** Journals that were not taken in, each with the reasons, until the reader has read them. */
import type { JournalFault } from '@pkg/formicarium'
import { signal } from '@preact/signals'

/** A run of which the file says something else than what is there. */
export interface UnlikeRun {
  /** Places in the question. */
  instance: number
  entry: number
  seed: number
  /** The file that has brought the other; null where it was done here. */
  by: string | null
}

export interface RefusedJournal {
  key: number
  name: string
  /** The first lines that do not hold. */
  faults: { line: number; fault: JournalFault }[]
  /** The first runs that say something else. */
  unlike: UnlikeRun[]
  /** How many lines and runs more. */
  more: number
}

export const refusedJournals = signal<RefusedJournal[]>([])

let nextKey = 1

/** In place of what was said of an earlier file of this name. */
export function noteRefusal(refusal: Omit<RefusedJournal, 'key'>): void {
  const others = refusedJournals.peek().filter(({ name }) => name !== refusal.name)
  refusedJournals.value = [...others, { ...refusal, key: nextKey++ }]
}

export function dismissRefusal(key: number): void {
  refusedJournals.value = refusedJournals.peek().filter((one) => one.key !== key)
}

/** Another comparison is open: what was said of the one before is no longer of use. */
export function forgetRefusals(): void {
  refusedJournals.value = []
}
