/**
 * The page's side of one panel's worker. It owns the canvas, because a canvas can be handed to a worker only once: whoever
 * shows the panel mounts this element, however often the page is rendered anew.
 */

import type { EngineError } from '@pkg/formicarium'
import { toEngineError } from '../model/errors'
import type { Stop } from '../model/lesson'
import type {
  Frame,
  LayerScale,
  PanelAnswers,
  PanelQuestion,
  PanelReply,
  PanelRequest,
  PanelView,
  RasterReply,
  RunSetup,
  Target,
} from '../model/messages'
import { type Build, buildForRun } from './builds'
import { modules } from './load'
import { newWorker, whyFailed } from './new_worker'

type Answer = PanelAnswers[keyof PanelAnswers] | null

interface Load {
  runId: number
  setup: RunSetup
}

/** The view of a panel that is not on screen, which runs all the same. */
const UNSEEN: PanelView = {
  width: 1,
  height: 1,
  scale: 1,
  originX: 0,
  originY: 0,
  dpr: 1,
  layer: 'none',
  ends: {},
  showAnts: false,
  showPath: false,
  showContours: false,
  hidden: true,
  theme: 'light',
  colour: '#000000',
  goalNames: [],
  cursor: null,
  cursorFocus: false,
}

/** Draws a panel's raster in three dimensions. */
export interface RasterWatcher {
  /** What lies on the map may have changed. */
  stale(): void
  take(raster: RasterReply): void
}

/** loading: no run yet, or a newer one is on its way · idle: can be ticked · failed: refused or crashed, until the next load */
type State = 'loading' | 'idle' | 'ticking' | 'failed'

export class PanelClient {
  state: State = 'loading'
  /** The newest answer of the current run. */
  frame: Frame | null = null
  /** What the colours of its map say, and who is told of changes. */
  scale: LayerScale | null = null
  onScale: ((scale: LayerScale) => void) | null = null
  private worker: Worker | null = null
  /** The build that the worker runs on. */
  private build: Build = 'core'
  private canvas: HTMLCanvasElement | null = null
  /** The canvas of a replaced worker, shown until the next one has drawn. */
  private faded: HTMLCanvasElement | null = null
  private host: HTMLElement | null = null
  private view: PanelView = UNSEEN
  private started = false
  private current: Load | null = null
  /** Posted and not answered yet; while it is, only the newest later load is kept. */
  private loadUnderWay: number | null = null
  private loadWaiting: Load | null = null
  private watcher: RasterWatcher | null = null
  private readonly waiting = new Map<number, (answer: Answer) => void>()
  private lastQuestion = 0

  constructor(private readonly onReply: (reply: PanelReply) => void) {}

  /** Shows the canvas in `host`; the same canvas moves when the page is laid out anew. */
  mount(host: HTMLElement): void {
    this.host = host
    if (this.canvas === null) this.renewCanvas()
    else host.append(this.canvas)
  }

  setView(view: PanelView): void {
    this.view = view
    if (this.started) this.post({ kind: 'view', view })
  }

  load(runId: number, setup: RunSetup): void {
    this.current = { runId, setup }
    this.frame = null
    this.state = 'loading'
    this.loadWaiting = this.current
    this.use(buildForRun(setup))
    if (this.started) this.postLoad()
    else if (this.worker === null) void this.start()
  }

  /** Tells `watcher` of changes of the raster, in place of any other watcher; null ends it. */
  watch(watcher: RasterWatcher | null): void {
    this.watcher = watcher
    watcher?.stale()
  }

  /** Asks for a raster, which goes to the watcher. False while there is no worker to ask. */
  askRaster(): boolean {
    if (this.started) this.post({ kind: 'raster' })
    return this.started
  }

  /** Asks about the current run; null when there is none, or none any more. */
  ask<About extends keyof PanelAnswers>(
    question: Extract<PanelQuestion, { about: About }>,
  ): Promise<PanelAnswers[About] | null> {
    const { current } = this
    if (!this.started || current === null) return Promise.resolve(null)
    const id = ++this.lastQuestion
    return new Promise((resolve) => {
      // The answer has the type that belongs to the question.
      this.waiting.set(id, (answer) => resolve(answer as PanelAnswers[About] | null))
      this.post({ kind: 'ask', runId: current.runId, id, question })
    })
  }

  tick(target: Target, sliceMs: number, stops?: Stop[]): void {
    if (this.state !== 'idle' || this.current === null) return
    this.state = 'ticking'
    this.post({ kind: 'tick', runId: this.current.runId, target, sliceMs, stops })
  }

  get finished(): boolean {
    return this.frame !== null && this.frame.status !== 'running'
  }

  /** Ends the worker, and with it the run and all its memory. */
  terminate(): void {
    this.worker?.terminate()
    this.leaveUnanswered()
    this.worker = null
    this.started = false
    this.canvas?.remove()
    this.canvas = null
    this.faded?.remove()
  }

  /** A worker is bound to one build, so another build needs a new worker. The old picture stays until the new worker has drawn. */
  private use(build: Build): void {
    // The whole engine can do all that the core can: a worker that has it stays.
    if (this.build === build || (this.started && this.build === 'whole')) return
    this.build = build
    this.worker?.terminate()
    this.leaveUnanswered()
    this.worker = null
    this.loadUnderWay = null
    if (!this.started) return
    this.started = false
    this.faded = this.canvas
    this.canvas = null
    this.renewCanvas()
  }

  private async start(): Promise<void> {
    if (this.canvas === null) this.renewCanvas()
    const worker = newWorker(this.build)
    this.worker = worker
    worker.onmessage = (event: MessageEvent<PanelReply>) => this.receive(event.data)
    worker.onerror = async (event) => {
      const error = await whyFailed(worker, event)
      if (this.worker === worker) this.fail(error)
    }
    try {
      const module = await modules[this.build]()
      if (this.worker === worker) this.hand(module)
    } catch (error) {
      if (this.worker === worker) this.fail(toEngineError(error))
    }
  }

  private hand(module: WebAssembly.Module): void {
    if (this.canvas === null) return
    const canvas = this.canvas.transferControlToOffscreen()
    this.worker?.postMessage(
      { kind: 'init', module, canvas, view: this.view } satisfies PanelRequest,
      [canvas],
    )
    this.started = true
    this.postLoad()
  }

  private postLoad(): void {
    if (this.loadWaiting === null || this.loadUnderWay !== null) return
    this.loadUnderWay = this.loadWaiting.runId
    this.post({ kind: 'load', ...this.loadWaiting })
    this.loadWaiting = null
  }

  private receive(reply: PanelReply): void {
    if (reply.kind === 'failed') this.fail(reply.error)
    else if (reply.kind === 'ready') this.onReply(reply)
    else if (reply.kind === 'raster') this.handRaster(reply)
    else if (reply.kind === 'scale') this.tellScale(reply)
    else if (reply.kind === 'answer') this.settle(reply.id, reply.answer)
    else this.answer(reply)
  }

  private settle(id: number, answer: Answer): void {
    this.waiting.get(id)?.(answer)
    this.waiting.delete(id)
    this.watcher?.stale()
  }

  /** A worker that is gone answers nothing. */
  private leaveUnanswered(): void {
    for (const resolve of this.waiting.values()) resolve(null)
    this.waiting.clear()
  }

  private tellScale(scale: LayerScale): void {
    this.scale = scale
    this.onScale?.(scale)
  }

  private handRaster(reply: RasterReply): void {
    if (this.watcher) this.watcher.take(reply)
    else reply.bitmap.close()
  }

  /** Answers to a run that has been replaced meanwhile are dropped. */
  private answer(reply: Extract<PanelReply, { runId: number }>): void {
    if (reply.runId === this.loadUnderWay) {
      this.loadUnderWay = null
      this.postLoad()
    }
    if (reply.runId !== this.current?.runId) return
    this.state = reply.kind === 'frame' ? 'idle' : 'failed'
    if (reply.kind === 'frame') this.frame = reply
    this.faded?.remove()
    this.watcher?.stale()
    this.onReply(reply)
  }

  /** The canvas is lost with its worker; a fresh one is ready for the next load. */
  private fail(error: EngineError): void {
    this.worker?.terminate()
    this.leaveUnanswered()
    this.worker = null
    this.started = false
    this.loadUnderWay = null
    this.loadWaiting = null
    this.state = 'failed'
    this.renewCanvas()
    this.onReply({ kind: 'failed', error })
  }

  private renewCanvas(): void {
    const canvas = document.createElement('canvas')
    canvas.setAttribute('aria-hidden', 'true')
    this.canvas?.remove()
    this.canvas = canvas
    this.host?.append(canvas)
  }

  private post(request: PanelRequest): void {
    this.worker?.postMessage(request)
  }
}
