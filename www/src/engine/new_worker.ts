/** Workers, and why one has not started. A worker's first message says whether it is a panel or a set of tools (worker/serve_worker.ts). */

import type { EngineError } from '@pkg/formicarium'
import { crash, toEngineError } from '../model/errors'
import { oneFile } from '../model/one_file'
import coreUrl from '../worker/core.worker?worker&url'
import wholeUrl from '../worker/whole.worker?worker&url'
import type { Build } from './builds'
import { fetchOwn } from './files_of_page'

/** Workers on the core that nobody has yet. */
const ahead: Worker[] = []
const addresses = new WeakMap<Worker, string>()

/** Starts workers on the core, for those who will want them soon. One that fails before is forgotten. */
export function startAhead(count: number): void {
  for (let i = 0; i < count; i++) {
    const worker = workerAt(coreUrl)
    worker.onerror = () => ahead.splice(ahead.indexOf(worker), 1)
    ahead.push(worker)
  }
}

/** A new worker on a build of the engine. */
export function newWorker(build: Build): Worker {
  return build === 'whole' ? workerAt(wholeUrl) : (ahead.pop() ?? workerAt(coreUrl))
}

/** A new worker with this script, one of the page's own. In the page as one file it is plain: without an origin there are no modules. */
export function workerAt(url: string): Worker {
  const worker = new Worker(url, { type: oneFile() ? 'classic' : 'module' })
  addresses.set(worker, url)
  return worker
}

/** What an error of a worker means: it has failed, or its script could not be fetched, of which browsers tell nothing. */
export async function whyFailed(worker: Worker, { message }: ErrorEvent): Promise<EngineError> {
  if (message) return crash(message)
  try {
    await fetchOwn(addresses.get(worker) ?? '')
  } catch (error) {
    return toEngineError(error)
  }
  return crash('the worker could not start')
}
