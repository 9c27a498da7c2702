/** Keeps all runs of the open comparison, and answers what they say. */
import * as engine from '@pkg/formicarium'
import type { AnalystCalls, KeptRun } from '../model/comparison_calls'
import { answerCalls } from './answer_calls'

let open: engine.Comparison | null = null

function comparison(): engine.Comparison {
  if (!open) throw new Error('no comparison is open')
  return open
}

const calls: AnalystCalls = {
  open(document) {
    open?.free()
    open = null
    open = new engine.Comparison(document)
    return {
      digest: open.digest(),
      mostShares: engine.most_shards(),
      outline: open.outline(),
      tasks: open.task_table(),
      order: open.seed_by_seed(),
      rows: rowsOf(open),
    }
  },
  keep(runs) {
    for (const { row, seconds } of runs) comparison().keep(row, seconds)
  },
  check(runs) {
    for (const { row } of runs) comparison().check(row)
  },
  analysis(axis, intervals) {
    const said = comparison().analysis(axis, intervals)
    return { ...said, ablation: intervals ? comparison().effects() : [] }
  },
  fronts: (asked) => comparison().fronts(asked),
  file: (kind, command, language, fronts) => comparison().file(kind, command, language, fronts),
  verify: () => comparison().verify() ?? null,
  dealt: (share) => comparison().dealt(share),
  shares(of) {
    const numbers = new Uint32Array(comparison().tasks())
    for (let share = 1; share <= of; share++)
      for (const task of comparison().dealt(`${share}/${of}`)) numbers[task] = share
    return numbers
  },
  journal: (share) => ({
    name: comparison().journal_name(share),
    text: comparison().journal(share),
  }),
  takeJournal: (text) => comparison().take_journal(text),
  digestIn: (journal) => engine.journal_digest(journal) ?? null,
  forget(indices) {
    for (const index of indices) comparison().forget(index)
  },
}

/** The runs that the document has brought along. */
function rowsOf(one: engine.Comparison): KeptRun[] {
  const left = new Set(one.open_tasks())
  const done = Array.from({ length: one.tasks() }, (_, index) => index).filter((i) => !left.has(i))
  return one.rows().map((row, place) => ({
    index: done[place] ?? 0,
    row,
    seconds: [],
    found: JSON.parse(row).found !== null,
  }))
}

answerCalls(calls, (module) => engine.initSync({ module }))
