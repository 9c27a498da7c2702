/** The whole engine's side of tools.ts: every file format. */
import * as engine from '@pkg/formicarium'
import { answerCalls } from './answer'
import type { FileCalls } from './tools'

const calls: FileCalls = {
  importMap: (bytes, name) => engine.import_map(bytes, name),
  importScen: (bytes) => engine.import_scen(bytes),
  sniff: (bytes, name) => engine.sniff(bytes, name),
  exportMap: (spec, cells, format) => engine.export_map(spec, cells, format),
}

answerCalls(calls, (module) => engine.initSync({ module }))
