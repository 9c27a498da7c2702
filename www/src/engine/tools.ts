/** The engine's calls that belong to no panel, as promises: catalog, import, export, generators, checks, what results are compared with. */
import type {
  Catalog,
  EngineError,
  Generator,
  Objective,
  ReadOptions,
  Reference,
  RunSummary,
} from '@pkg/formicarium'
import { toEngineError } from '../model/errors'
import type { RunSetup } from '../model/messages'
import type { RecordedResult, Scenario } from '../model/session'
import type { MapCalls, ToolCalls, ToolReply, ToolRequest, WholeMap } from '../model/tool_calls'
import { asksForWhole, type Build, buildForRun, noteCore } from './builds'
import { modules } from './load'
import { newWorker, whyFailed } from './new_worker'

interface Waiting {
  resolve(value: unknown): void
  reject(error: EngineError): void
}

/** Calls as a worker offers them. */
type Calls<C> = { [K in keyof C]: (...args: never[]) => unknown }

/** One worker and its unanswered calls. */
export class ToolBox<C extends Calls<C>> {
  private readonly waiting = new Map<number, Waiting>()
  private readonly ready: Promise<void>
  private nextId = 1
  private failure: EngineError | null = null
  dead = false

  constructor(
    build: Build,
    private readonly worker = newWorker(build),
  ) {
    this.worker.onmessage = (event: MessageEvent<ToolReply>) => this.settle(event.data)
    this.worker.onerror = async (event) => this.fail(await whyFailed(this.worker, event))
    this.ready = modules[build]().then((module) =>
      this.worker.postMessage({ kind: 'init', module } satisfies ToolRequest),
    )
    this.ready.catch(() => this.terminate())
  }

  async call<K extends keyof C & string>(
    call: K,
    ...args: Parameters<C[K]>
  ): Promise<ReturnType<C[K]>> {
    await this.ready.catch((error: unknown) => Promise.reject(toEngineError(error)))
    if (this.failure) throw this.failure
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
      if (reply.error.kind === 'engine-crashed') this.fail(reply.error)
    }
  }

  private fail(failure: EngineError): void {
    this.failure = failure
    this.terminate()
    for (const waiting of this.waiting.values()) waiting.reject(failure)
    this.waiting.clear()
  }
}

export const mapOf = ({ spec, cells, heights, factors }: Scenario): WholeMap => [
  spec,
  cells,
  heights,
  factors,
]

/** A worker made at its first call and replaced after it has failed. */
function lazyBox<C extends Calls<C>>(make: () => ToolBox<C>): () => ToolBox<C> {
  let box: ToolBox<C> | null = null
  return () => {
    if (box === null || box.dead) box = make()
    return box
  }
}

const newCoreBox = () => new ToolBox<ToolCalls>('core')
const newWholeBox = () => new ToolBox<ToolCalls & MapCalls>('whole')
/** A worker of its own, so that no other call has to wait. */
const newBox = (build: Build): ToolBox<ToolCalls> =>
  build === 'core' ? newCoreBox() : (newWholeBox() as ToolBox<ToolCalls>)

const toolBox = lazyBox(newCoreBox)
/** For exact searches, which take a while on large maps: no other call waits behind them. */
const searchBox = lazyBox(newCoreBox)
const wholeSearchBox = lazyBox(newWholeBox)
export const wholeBox = lazyBox(newWholeBox)

export const tools = {
  /** The planners of the core. */
  async catalog(): Promise<Pick<Catalog, 'planners'>> {
    const catalog = await toolBox().call('catalog')
    noteCore(catalog)
    return catalog
  },
  /** All planners; fetches the whole engine. */
  wholeCatalog: () => wholeBox().call('catalog'),
  version: () => toolBox().call('version'),
  /** `image`: of a ROS map the picture that it names. */
  importMap: (bytes: Uint8Array, name: string, options?: ReadOptions, image?: Uint8Array) =>
    wholeBox().call('importMap', bytes, name, options, image),
  importScen: (bytes: Uint8Array) => wholeBox().call('importScen', bytes),
  /** Tells what a file is. */
  recognise: (bytes: Uint8Array, name: string) => wholeBox().call('recognise', bytes, name),
  /** Rules of movement by slices that suit a terrain, with so many metres per unit of its heights. */
  fittingSlices: (map: Scenario, verticalUnit: number) =>
    wholeBox().call('fittingSlices', ...mapOf(map), verticalUnit),
  generate: (kind: Generator, width: number, height: number, seed: number, density: number) =>
    wholeBox().call('generate', kind, width, height, seed, density),
  check: (map: Scenario) =>
    (asksForWhole(map) ? wholeBox() : toolBox()).call('check', ...mapOf(map)),
  proposeSeed: () => toolBox().call('proposeSeed'),
  /** The reference of the scenario for this objective. The core only knows the one for lengths of step paths. */
  reference: (map: Scenario, objective: Objective): Promise<Reference> =>
    (objective === 'length' && !asksForWhole(map) ? searchBox() : wholeSearchBox()).call(
      'reference',
      ...mapOf(map),
      objective,
    ),
  /** Repeats a recorded run as far as it went, in a worker of its own, so that no other call has to wait. */
  async replay(setup: RunSetup, recorded: RecordedResult): Promise<RunSummary> {
    const own = newBox(buildForRun(setup))
    try {
      return await own.call('repeat', setup, recorded.iterations)
    } finally {
      own.terminate()
    }
  },
}
