/** Panels and tools on the whole engine; only it has file formats and generators. */
import * as engine from '@pkg/formicarium'
import { serve } from './serve'
import { toolCalls } from './tool_calls'
import type { MapCalls, ToolCalls } from './tools'

const calls: ToolCalls & MapCalls = {
  ...toolCalls(engine),
  importMap: (bytes, name) => engine.import_map(bytes, name),
  importScen: (bytes) => engine.import_scen(bytes),
  sniff: (bytes, name) => engine.sniff(bytes, name),
  exportMap: (spec, cells, format) => engine.export_map(spec, cells, format),
  generate: (kind, width, height, seed, density) =>
    engine.generate(kind, width, height, seed, density),
}

serve(engine, calls)
