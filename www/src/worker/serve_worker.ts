/**
 * A worker on one build of the engine. Panels and tools start from the same file, so that a first visit fetches it once: what the
 * first message asks for is what the worker becomes.
 */
import type { PanelRequest } from '../model/messages'
import type { ToolRequest } from '../model/tool_calls'
import { answerCalls } from './answer_calls'
import { type GroundOf, type PanelEngine, servePanel } from './panel_server'

/** `ground`: of the build that knows terrains. */
export function serve(engine: PanelEngine, calls: object, ground: GroundOf = () => null): void {
  self.onmessage = (event: MessageEvent<PanelRequest | ToolRequest>) => {
    if ('canvas' in event.data) servePanel(engine, ground)
    else answerCalls(calls, (module) => engine.initSync({ module }))
    // The first message is handed to the listener that has just been installed.
    self.onmessage?.(event)
  }
}
