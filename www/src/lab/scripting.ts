/** Comparisons for scripts: `await formicarium.compare({ seeds: 30 })`. */
import type { ReportLanguage, ResultFile } from '@pkg/formicarium'
import { effect } from '@preact/signals'
import { optionsOf, ScriptError, shortText, wholeNumber } from '../model/script_error'
import type { Asked, CompareOptions, ComparisonResult } from '../model/scripting'
import { showView } from '../state'
import { compose } from './build/compose_document'
import { ASKED, draftFromScript } from './build/script_draft'
import * as run from './run/actions'
import { MOST_WORKERS } from './run/pool'
import { openAddress } from './view/open_address'

const FILES = ['csv', 'markdown', 'tests', 'json'] as const
/** Every kind, by the type check. */
const KINDS: Record<ResultFile, true> = {
  csv: true,
  markdown: true,
  tests: true,
  'tests-csv': true,
  'summary-csv': true,
  'summary-json': true,
  'summary-markdown': true,
  'claims-csv': true,
  'matrix-csv': true,
  'matrix-markdown': true,
  'matrix-latex': true,
  'fronts-csv': true,
  'fronts-markdown': true,
  'fronts-latex': true,
  latex: true,
  json: true,
  link: true,
}

/** Their languages, by the type check. */
const REPORTS: Record<ReportLanguage, true> = { en: true, 'zh-CN': true }

export async function compare(given?: CompareOptions): Promise<ComparisonResult> {
  const options = optionsOf(given, ['document', 'workers', 'command', ...ASKED], 'compare')
  const { document, workers, command, ...asked } = options as CompareOptions
  const most =
    workers === undefined ? {} : { workers: wholeNumber(workers, 'workers', 1, MOST_WORKERS) }
  const how = command === undefined ? {} : { command: shortText(command, 'command', 1000) }
  showView('lab')
  await openAddress()
  const text = document === undefined ? await composed(asked) : documentAlone(document, asked)
  if (run.phase.peek() === 'running') run.tellStopped()
  const began = performance.now()
  await run.startComparison(text, most)
  await atRest()
  const seconds = (performance.now() - began) / 1000
  const { done: runs, pathless, failed, total } = run.progress.peek()
  const written = FILES.map(async (kind) => [kind, await run.resultFile(kind, how)] as const)
  const files = Object.fromEntries(await Promise.all(written)) as ComparisonResult['files']
  return { runs, pathless, failed, total, seconds, files }
}

async function composed(asked: Asked): Promise<string> {
  await draftFromScript(asked)
  return compose()
}

function documentAlone(document: unknown, asked: Asked): string {
  const [also] = Object.keys(asked)
  if (also !== undefined) {
    const message = `${also} cannot be given beside a document`
    throw new ScriptError('options-exclude', also, message, 'Change the document, or leave it out.')
  }
  if (typeof document === 'string') return document
  const hint = 'Pass JSON.stringify(document).'
  throw new ScriptError('bad-option', 'document', 'document must be a text', hint)
}

/** A result file of the open comparison; what people read is in English, whatever the page is in, or as asked for. */
export async function resultFile(kind: ResultFile, language?: ReportLanguage): Promise<string> {
  if (!Object.hasOwn(KINDS, kind)) {
    const hint = `There are ${Object.keys(KINDS).join(', ')}.`
    throw new ScriptError('unknown-file', 'file', `there is no result file "${kind}"`, hint)
  }
  if (language !== undefined && !Object.hasOwn(REPORTS, language)) {
    const hint = `There are ${Object.keys(REPORTS).join(', ')}.`
    throw new ScriptError('bad-option', 'language', `no report is in "${language}"`, hint)
  }
  await openAddress()
  if (run.openComparison.peek()) return run.resultFile(kind, language ? { language } : {})
  const hint = 'Call compare, load one, or open an earlier one.'
  throw new ScriptError('no-comparison', '', 'no comparison is open', hint)
}

/** Once nothing runs any more; throws where another comparison has taken its place. */
function atRest(): Promise<void> {
  const mine = run.openComparison.peek()?.id
  return new Promise((resolve, reject) => {
    const stop = effect(() => {
      const isOpen = run.openComparison.value?.id === mine
      if (isOpen && run.phase.value === 'running') return
      if (isOpen) resolve()
      else reject(leftEarly())
      queueMicrotask(() => stop())
    })
  })
}

function leftEarly(): ScriptError {
  const hint = 'The runs that were done are kept: it can go on later.'
  return new ScriptError('comparison-left', '', 'the comparison was closed before its end', hint)
}
