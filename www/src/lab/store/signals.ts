/** What every part of the laboratory reads. Written by the actions in state.ts alone, but for `axis`, which is a mere choice of the reader. */
import type { Axis, EngineError, Verification } from '@pkg/formicarium'
import { computed, signal } from '@preact/signals'
import type { Analysis } from '../../model/analysis'
import type { LabDocument, MapOfQuestion, Question } from '../../model/comparison'
import type { KeptStudy } from './shelf'

/** idle: nothing is open · opening · running · paused: some runs are to be done · done */
export type Phase = 'idle' | 'opening' | 'running' | 'paused' | 'done'

export interface Failure {
  index: number
  /** The entry's label and the seed. */
  what: string
  error: EngineError
}

/** An experiment that is open. */
export interface Study {
  /** Its key in the storage. */
  id: string
  title: string
  /** `formicarium/comparison@1` without its runs, but with what was recorded of them, if it came from elsewhere. */
  document: string
  question: Question
  maps: MapOfQuestion[]
  /** What was recorded by whoever ran it before, when it was opened from a file or a link. */
  recorded: LabDocument['recorded'] | null
  /** Where its runs come from: they were done here, or stood in the file that was opened. */
  runs: 'own' | 'file'
  /** Only the first so many seeds of each entry are to be run; null: all. */
  firstSeeds: number | null
  /** Another tab is running it. */
  elsewhere: boolean
}

export interface Progress {
  /** Runs that are done, and to be done altogether. */
  done: number
  total: number
  /** Of the done ones those that were there before this page was opened. */
  kept: number
  /** Of the done ones those that found no path. */
  pathless: number
  /** Runs that could not be done; none of them is among the done ones. */
  failed: number
  /** How long the rest will take; null while nobody can tell. */
  secondsLeft: number | null
}

export const NO_PROGRESS: Progress = {
  done: 0,
  total: 0,
  kept: 0,
  pathless: 0,
  failed: 0,
  secondsLeft: null,
}

/** Runs that are under way though it was paused: they are finished first. */
export const finishing = signal(0)
/** Why runs could not be done; of each entry and map the first. */
export const failures = signal<Failure[]>([])
/** Why there is no analysis. */
export const analysisError = signal<EngineError | null>(null)
/** Experiments of this browser, the newest first; null while they are being read, or where nothing can be kept. */
export const keptList = signal<KeptStudy[] | null>(null)

export const study = signal<Study | null>(null)
export const phase = signal<Phase>('idle')
export const progress = signal<Progress>(NO_PROGRESS)
/** Of the runs that are done so far; at most twice a second while more are done. Its intervals come at rest. */
export const analysis = signal<Analysis | null>(null)
/** What effort is counted in. */
export const axis = signal<Axis>('constructed-paths')
/** How far the runs are what was recorded; null where nothing was recorded. */
export const verification = signal<Verification | null>(null)

/** What the switch of fair budgets offers. */
export const AXES = ['iterations', 'constructed-paths', 'moves', 'time'] as const satisfies Axis[]

/** Entries `full` and `without-…`: what each component of a planner is good for. */
export const isAblation = computed(() => {
  const ids = study.value?.question.entries.map(({ id }) => id) ?? []
  return ids.includes('full') && ids.some((id) => id.startsWith('without-'))
})
