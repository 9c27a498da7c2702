/** A new worker on a build of the engine; its first message says whether it is a panel or a set of tools (worker/serve_worker.ts). */

import CoreWorker from '../worker/core.worker?worker'
import WholeWorker from '../worker/whole.worker?worker'
import type { Build } from './builds'

/** Workers on the core that nobody has yet. */
const ahead: Worker[] = []

/** Starts workers on the core, for those who will want them soon. One that fails before is forgotten. */
export function startAhead(count: number): void {
  for (let i = 0; i < count; i++) {
    const worker = new CoreWorker()
    worker.onerror = () => ahead.splice(ahead.indexOf(worker), 1)
    ahead.push(worker)
  }
}

export function newWorker(build: Build): Worker {
  return build === 'whole' ? new WholeWorker() : (ahead.pop() ?? new CoreWorker())
}
