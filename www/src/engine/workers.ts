/** A new worker on a build of the engine; its first message says whether it is a panel or a set of tools (serve.ts). */
import type { Build } from './builds'
import CoreWorker from './core.worker?worker'
import WholeWorker from './whole.worker?worker'

export function newWorker(build: Build): Worker {
  return build === 'core' ? new CoreWorker() : new WholeWorker()
}
