/** How long runs took, as CSV. Times hold for this machine only, so no other result file has them. */
import type { Question } from '@pkg/formicarium'
import type { KeptRun } from '../../model/comparison_calls'
import { csvOf } from './csv'

const HEADER = ['instance', 'entry', 'seed', 'seconds_to_best', 'seconds']

/** One line a run that was done in this browser, in the order of the other files. */
export function timesCsv(question: Question, runs: Iterable<KeptRun>): string {
  const timed = [...runs].filter(({ seconds }) => seconds.length > 0)
  timed.sort((a, b) => a.index - b.index)
  return csvOf(
    HEADER,
    timed.map((run) => cells(question, run)),
  )
}

/** `seconds` has one number for each improvement, and one for the end. */
function cells({ instances, entries }: Question, { row, seconds, found }: KeptRun) {
  const { task } = JSON.parse(row) as { task: { instance: number; entry: number; seed: number } }
  const best = found ? seconds.at(-2) : undefined
  const numbers = [best, seconds.at(-1)].map((value) => value?.toFixed(6))
  return [instances[task.instance]?.id, entries[task.entry]?.id, task.seed, ...numbers]
}
