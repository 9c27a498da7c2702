/** What every part of the laboratory reads. Only lab/run writes it, except `axis`, which the reader chooses. */
import type { Axis, ComparisonOutline, EngineError, Question, Verification } from '@pkg/formicarium'
import { computed, signal } from '@preact/signals'
import type { Analysis } from '../../model/analysis'
import type { ComparisonDocument, MapOfQuestion } from '../../model/comparison'
import type { NumbersOfLink } from '../../share/recorded_numbers'
import type { ShareOfClass } from '../../share/share_of_class'
import type { BroughtFile, StoredComparison } from './browser_storage'

/** idle: nothing is open · opening · running · paused: some runs are to be done · done */
export type Phase = 'idle' | 'opening' | 'running' | 'paused' | 'done'

export interface Failure {
  index: number
  /** The entry's label and the seed. */
  what: string
  error: EngineError
}

/** The comparison that is open. */
export interface OpenComparison {
  /** Its key in the browser's storage. */
  id: string
  title: string
  /** `formicarium/comparison@1` without its runs; a file or link also brings what was recorded of them. */
  document: string
  question: Question
  maps: MapOfQuestion[]
  /** What the engine tells of it before anything has run. */
  outline: ComparisonOutline
  /** What was recorded when it was run elsewhere; null where nothing was. */
  recorded: ComparisonDocument['recorded'] | null
  /** What the link that it came in tells of those runs; null where none does. */
  numbers: NumbersOfLink | null
  /** Where its runs come from: done here (`own`), or read from a file. */
  runs: 'own' | 'file'
  /** Only this many seeds of each entry are to be run, the first ones; null: all. */
  firstSeeds: number | null
  /** Over question and maps: journals name it. */
  digest: string
  /** Most shares that it can be dealt to. */
  mostShares: number
  /** The share of a class that is done here; null where all runs are. */
  share: ShareOfClass | null
  /** To how many shares it was dealt here; null where it was not. */
  dealt: number | null
  /** Files of others that have brought runs. */
  brought: BroughtFile[]
  /** Another tab is running it. */
  elsewhere: boolean
}

export interface Progress {
  /** Runs that are done, and to be done altogether. */
  done: number
  total: number
  /** Of the done ones, those that were there when it was opened. */
  kept: number
  /** Of the done ones, those that found no path. */
  pathless: number
  /** Runs that could not be done; they are not counted as done. */
  failed: number
  /** Estimated time for the remaining runs; null while there is too little to go by. */
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

/** Runs still under way after a pause: they are finished. */
export const finishing = signal(0)
/** Why runs could not be done, each reason once. */
export const failures = signal<Failure[]>([])
/** Why there is no analysis. */
export const analysisError = signal<EngineError | null>(null)
/** The list of comparisons that this browser has stored, newest first; null while it is being read, or where nothing can be stored. */
export const keptComparisons = signal<StoredComparison[] | null>(null)

export const openComparison = signal<OpenComparison | null>(null)
export const phase = signal<Phase>('idle')
export const progress = signal<Progress>(NO_PROGRESS)
/** What the finished runs say; updated while runs go on, with intervals once they rest. */
export const analysis = signal<Analysis | null>(null)
/** What effort is counted in. */
export const axis = signal<Axis>('constructed-paths')
/** How far the runs agree with what was recorded; null where nothing was recorded. */
export const verification = signal<Verification | null>(null)

/** The axes that the reader can choose from. */
export const AXES = ['iterations', 'constructed-paths', 'moves', 'time'] as const satisfies Axis[]

/** Whether it asks what each component of a planner is good for. */
export const isAblation = computed(
  () => openComparison.value?.outline.ablation_roles.some((role) => role !== null) ?? false,
)
