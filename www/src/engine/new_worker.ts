/** A new worker on a build of the engine; its first message says whether it is a panel or a set of tools (worker/serve_worker.ts). */

import CoreWorker from '../worker/core.worker?worker'
import WholeWorker from '../worker/whole.worker?worker'
import type { Build } from './builds'

export function newWorker(build: Build): Worker {
  return build === 'core' ? new CoreWorker() : new WholeWorker()
}
