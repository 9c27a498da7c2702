/** What came out of a comparison's runs, as its link tells it beside their digests: read at once, verified only when the runs are done again. */
import type { Question } from '@pkg/formicarium'
import { integer, invalid, list, real } from './field_checks'

/** Runs of one entry on one map. Best, median and the median's gap are over those with a path; null where nothing is known. */
export interface RecordedNumbers {
  runs: number
  withPath: number
  best: number | null
  median: number | null
  gap: number | null
}

/** For each map and entry of the question; null without runs. */
export type NumbersOfLink = (RecordedNumbers | null)[][]

/** Digits enough for any table. */
const DIGITS = 7
const MOST = 10_000
const MOST_RUNS = 2_000_000
const LARGEST = 1e15

/** As short as it can be said: five numbers each, in the order of the fields. */
export const packedNumbers = (numbers: NumbersOfLink): string =>
  JSON.stringify(
    numbers.map((map) =>
      map.map(
        (one) => one && [one.runs, one.withPath, ...[one.best, one.median, one.gap].map(short)],
      ),
    ),
  )

const short = (value: number | null) => value && Number(value.toPrecision(DIGITS))

/** Throws a LinkError that names what is none. */
export function readNumbers(value: unknown): NumbersOfLink {
  return list(value, 'numbers', MOST).map((map, i) =>
    list(map, `numbers[${i}]`, MOST).map((one, j) =>
      one === null ? null : readOne(one, `numbers[${i}][${j}]`),
    ),
  )
}

function readOne(value: unknown, field: string): RecordedNumbers {
  const all = list(value, field, 5)
  if (all.length !== 5) throw invalid(field, 'must have five numbers')
  const [runs, withPath, best, median, gap] = all
  const least = { best: 0, median: 0, gap: -1 }
  const maybe = (name: keyof typeof least, one: unknown) =>
    one === null ? null : real(one, `${field}.${name}`, least[name], LARGEST)
  const count = integer(runs, `${field}.runs`, 1, MOST_RUNS)
  return {
    runs: count,
    withPath: integer(withPath, `${field}.withPath`, 0, count),
    best: maybe('best', best),
    median: maybe('median', median),
    gap: maybe('gap', gap),
  }
}

/** Refuses numbers of another question: one list a map, one place an entry. */
export function checkNumbers(
  numbers: NumbersOfLink,
  { instances, entries }: Pick<Question, 'instances' | 'entries'>,
): void {
  if (numbers.length !== instances.length)
    throw invalid('numbers', `must have as many maps as the question, ${instances.length}`)
  const wrong = numbers.findIndex((map) => map.length !== entries.length)
  if (wrong >= 0)
    throw invalid(
      `numbers[${wrong}]`,
      `must have as many entries as the question, ${entries.length}`,
    )
}
