/** Comparisons for scripts: `await formicarium.compare({ seeds: 30 })`. */
import { effect } from '@preact/signals'
import { showView } from '../state'
import { compose } from './build/compose_document'
import { seeds, takeRace } from './build/draft'
import { phase, progress, resultFile, startComparison } from './run/actions'
import { openAddress } from './view/open_address'

export interface CompareOptions {
  /** A `formicarium/comparison@1` document, as text; the map and the planners that race now, if none is given. */
  document?: string
  /** Of each planner, from 1 on; 30 if nothing is said. A document has its own. */
  seeds?: number
  /** As many as the machine has processors, if nothing is said. */
  workers?: number
  /** How the Markdown file says that it was made; how the same comes from the command line, if nothing is said. */
  command?: string
}

export interface ComparisonResult {
  /** Runs that are done, those of them without a path, and runs that could not be done. */
  runs: number
  pathless: number
  failed: number
  /** From the first run's beginning to the last one's end. */
  seconds: number
  /** The result files, as the command line writes them. */
  files: Record<(typeof FILES)[number], string>
}

const FILES = ['csv', 'markdown', 'tests', 'json'] as const

export async function compare(options: CompareOptions = {}): Promise<ComparisonResult> {
  showView('lab')
  await openAddress()
  const { document, workers, command } = options
  const text = document ?? (await racing(options.seeds ?? 30))
  const began = performance.now()
  await startComparison(text, workers === undefined ? {} : { workers })
  await atRest()
  const seconds = (performance.now() - began) / 1000
  const { done: runs, pathless, failed } = progress.peek()
  const written = FILES.map(async (kind) => [kind, await resultFile(kind, command)] as const)
  const files = Object.fromEntries(await Promise.all(written)) as ComparisonResult['files']
  return { runs, pathless, failed, seconds, files }
}

function racing(count: number): Promise<string> {
  takeRace()
  seeds.value = { from: 1, count }
  return compose()
}

function atRest(): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (phase.value === 'running') return
      resolve()
      queueMicrotask(() => stop())
    })
  })
}
