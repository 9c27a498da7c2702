/** The whole engine's side of tools.ts: file formats and generators. */
import * as engine from '@pkg/formicarium'
import { answerCalls } from './answer'
import type { MapCalls } from './tools'

const calls: MapCalls = {
  importMap: (bytes, name) => engine.import_map(bytes, name),
  importScen: (bytes) => engine.import_scen(bytes),
  sniff: (bytes, name) => engine.sniff(bytes, name),
  exportMap: (spec, cells, format) => engine.export_map(spec, cells, format),
  generate: (kind, width, height, seed, density) =>
    engine.generate(kind, width, height, seed, density),
}

answerCalls(calls, (module) => engine.initSync({ module }))
