/** A worker that answers calls by name, one at a time, in order. */
import { toEngineError } from '../model/errors'
import type { ToolReply, ToolRequest } from '../model/tool_calls'

/** Listens for calls; `init` makes the engine instance from the compiled module, before the first of them. */
export function answerCalls<Calls extends object>(
  calls: Calls,
  init: (module: WebAssembly.Module) => void,
): void {
  const answer = (request: Exclude<ToolRequest, { kind: 'init' }>): ToolReply => {
    try {
      const call = calls[request.call as keyof Calls] as (...args: unknown[]) => unknown
      return { id: request.id, ok: true, value: call(...request.args) }
    } catch (thrown) {
      return { id: request.id, ok: false, error: toEngineError(thrown) }
    }
  }
  self.onmessage = (event: MessageEvent<ToolRequest>) => {
    const request = event.data
    if (request.kind === 'init') init(request.module)
    else self.postMessage(answer(request))
  }
}
