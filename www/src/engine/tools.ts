/** The engine's calls that belong to no panel, as promises: catalog, import, export, generators, checks, the exact optimum. */
import type {
  Catalog,
  EngineError,
  Generated,
  Imported,
  Notice,
  RunSummary,
  ScenarioSpec,
  ScenFile,
} from '@pkg/formicarium'
import type { RunSetup } from '../messages'
import type { Origin, RecordedResult, Scenario } from '../session'
import { crash } from './errors'
import { coreModule, wholeModule } from './load'
import MapsWorker from './maps.worker?worker'
import ToolsWorker from './tools.worker?worker'

export type MapFormat = 'movingai-map' | 'movingai-scen' | 'matrix' | 'scenario'
export type FileKind =
  | 'movingai-map'
  | 'movingai-scen'
  | 'matrix'
  | 'scenario'
  | 'experiment'
  | 'unknown'

/** What the maps worker can do, as plain functions on its side. */
export interface MapCalls {
  importMap(bytes: Uint8Array, name: string): Imported
  importScen(bytes: Uint8Array): ScenFile
  sniff(bytes: Uint8Array, name: string): FileKind
  exportMap(spec: ScenarioSpec, cells: Uint8Array, format: MapFormat): string
  generate(
    kind: Origin['generator'],
    width: number,
    height: number,
    seed: number,
    density: number,
  ): Generated
}

/** What the tools worker can do, as plain functions on its side. */
export interface ToolCalls {
  catalog(): Catalog
  version(): string
  check(spec: ScenarioSpec, cells: Uint8Array): Notice[]
  proposeSeed(): number
  optimum(spec: ScenarioSpec, cells: Uint8Array): number
  repeat(setup: RunSetup, iterations: number): RunSummary
}

export type ToolRequest =
  | { kind: 'init'; module: WebAssembly.Module }
  | { kind: 'call'; id: number; call: string; args: unknown[] }
export type ToolReply =
  | { id: number; ok: true; value: unknown }
  | { id: number; ok: false; error: EngineError }

interface Waiting {
  resolve(value: unknown): void
  reject(error: EngineError): void
}

/** Calls as a worker offers them. */
type Calls<C> = { [K in keyof C]: (...args: never[]) => unknown }

/** One worker and the calls it still owes an answer. */
class ToolBox<C extends Calls<C>> {
  private readonly waiting = new Map<number, Waiting>()
  private readonly ready: Promise<void>
  private nextId = 1
  dead = false

  constructor(
    private readonly worker: Worker,
    compiled: () => Promise<WebAssembly.Module>,
  ) {
    this.worker.onmessage = (event: MessageEvent<ToolReply>) => this.settle(event.data)
    this.worker.onerror = (event) => this.fail(event.message || 'the worker could not start')
    this.ready = compiled().then((module) =>
      this.worker.postMessage({ kind: 'init', module } satisfies ToolRequest),
    )
    this.ready.catch((error: unknown) =>
      this.fail(error instanceof Error ? error.message : String(error)),
    )
  }

  async call<K extends keyof C & string>(
    call: K,
    ...args: Parameters<C[K]>
  ): Promise<ReturnType<C[K]>> {
    await this.ready.catch((error: unknown) => Promise.reject(crash(String(error))))
    const id = this.nextId++
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as Waiting['resolve'], reject })
      this.worker.postMessage({ kind: 'call', id, call, args } satisfies ToolRequest)
    })
  }

  terminate(): void {
    this.dead = true
    this.worker.terminate()
  }

  private settle(reply: ToolReply): void {
    const waiting = this.waiting.get(reply.id)
    this.waiting.delete(reply.id)
    if (reply.ok) waiting?.resolve(reply.value)
    else {
      waiting?.reject(reply.error)
      // After a trap the instance's memory cannot be trusted: the next call gets a fresh worker.
      if (reply.error.kind === 'engine-crashed') this.fail(reply.error.message)
    }
  }

  private fail(message: string): void {
    this.terminate()
    for (const waiting of this.waiting.values()) waiting.reject(crash(message))
    this.waiting.clear()
  }
}

/** A worker made at its first call and replaced after it has failed. */
function lazyBox<C extends Calls<C>>(make: () => ToolBox<C>): () => ToolBox<C> {
  let box: ToolBox<C> | null = null
  return () => {
    if (box === null || box.dead) box = make()
    return box
  }
}

const newToolBox = () => new ToolBox<ToolCalls>(new ToolsWorker(), coreModule)
const toolBox = lazyBox(newToolBox)
/** Exact searches may take a while on large maps: nothing must queue behind them. */
const searchBox = lazyBox(newToolBox)
const mapBox = lazyBox(() => new ToolBox<MapCalls>(new MapsWorker(), wholeModule))

export const tools = {
  catalog: () => toolBox().call('catalog'),
  version: () => toolBox().call('version'),
  importMap: (bytes: Uint8Array, name: string) => mapBox().call('importMap', bytes, name),
  importScen: (bytes: Uint8Array) => mapBox().call('importScen', bytes),
  sniff: (bytes: Uint8Array, name: string) => mapBox().call('sniff', bytes, name),
  exportMap: (spec: ScenarioSpec, cells: Uint8Array, format: MapFormat) =>
    mapBox().call('exportMap', spec, cells, format),
  generate: (
    kind: Origin['generator'],
    width: number,
    height: number,
    seed: number,
    density: number,
  ) => mapBox().call('generate', kind, width, height, seed, density),
  check: (spec: ScenarioSpec, cells: Uint8Array) => toolBox().call('check', spec, cells),
  proposeSeed: () => toolBox().call('proposeSeed'),
  /** Length of the shortest path under the scenario's own movement rule; Infinity when there is none. */
  optimum: (scenario: Scenario) => searchBox().call('optimum', scenario.spec, scenario.cells),
  /** Repeats a recorded run as far as it went, in a worker of its own: a long one holds nobody up. */
  async replay(setup: RunSetup, recorded: RecordedResult): Promise<RunSummary> {
    const own = newToolBox()
    try {
      return await own.call('repeat', setup, recorded.iterations)
    } finally {
      own.terminate()
    }
  },
}
