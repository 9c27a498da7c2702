/** How well an ant's moves were guessed, held against what anybody could expect. */
import type { AntMove } from '@pkg/formicarium'

/** A guess with what it was worth. */
export interface Answer {
  guessed: AntMove
  taken: AntMove
  /** The largest probability that any move had. */
  best: number
}

export interface Score {
  right: number
  count: number
  /** How often the guesses were to be expected right: the mean of their probabilities. */
  yours: number
  /** The same for guesses that are always the likeliest move: nobody can expect more. */
  best: number
}

export function scoreOf(all: Answer[]): Score | null {
  const count = all.length
  if (count === 0) return null
  const mean = (value: (answer: Answer) => number) =>
    all.reduce((sum, answer) => sum + value(answer), 0) / count
  return {
    right: all.filter(isRight).length,
    count,
    yours: mean(({ guessed }) => guessed.probability),
    best: mean(({ best }) => best),
  }
}

export const isRight = ({ guessed, taken }: Answer) =>
  guessed.to[0] === taken.to[0] && guessed.to[1] === taken.to[1] && guessed.level === taken.level
