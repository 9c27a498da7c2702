/** Keeps all runs of the open experiment, and answers what they say. */
import * as engine from '@pkg/formicarium'
import { answerCalls } from '../engine/answer'
import type { AnalystCalls, KeptRun } from './analyst'

let open: engine.Experiment | null = null

function experiment(): engine.Experiment {
  if (!open) throw new Error('no experiment is open')
  return open
}

const calls: AnalystCalls = {
  open(document) {
    open?.free()
    open = null
    open = new engine.Experiment(document)
    return { tasks: open.tasks(), rows: rowsOf(open), engine: engine.version() }
  },
  keep(runs) {
    for (const { row, seconds } of runs) experiment().keep(row, seconds)
  },
  check(runs) {
    for (const { row } of runs) experiment().check(row)
  },
  analysis(axis, intervals) {
    const said = experiment().analysis(axis, intervals)
    return { ...said, ablation: intervals ? experiment().effects() : [] }
  },
  file: (kind, command) => experiment().file(kind, command),
  verify: () => experiment().verify() ?? null,
}

/** The runs that the document has brought along. */
function rowsOf(one: engine.Experiment): KeptRun[] {
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
