/** Which ant is asked about, on which walk, and how far the questions have come: the same seed, ant and iteration ask the same. */
import { computed, signal } from '@preact/signals'
import { lesson } from '../state'
import type { Answer } from './score'

export const askedAbout = computed(() => lesson.value?.questions ?? null)

/** Moves of the walk that are behind the question. */
export const guessMoves = signal(0)

/** In the order of the walk. */
export const answers = signal<Answer[]>([])
/** What is being shown before the next question. */
export const revealed = signal<Answer | null>(null)
