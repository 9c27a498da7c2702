/**
 * One panel, on whichever build of the engine: one instance, one canvas, at most one run. Everything it does answers a request
 * (see messages.ts).
 */
import type * as core from '@pkg/core/formicarium'
import { crash, isEngineError } from '../model/errors'
import { KEPT_BYTES } from '../model/kept_bytes'
import type { Stop } from '../model/lesson'
import type {
  Frame,
  PanelQuestion,
  PanelReply,
  PanelRequest,
  RunSetup,
  Target,
} from '../model/messages'
import { type Ground, Painter } from './painter'
import { Stepper } from './stepper'
import type { StopWatch } from './stop_watch'

/** What a panel needs of a build. */
export type PanelEngine = Pick<typeof core, 'initSync' | 'paint_map' | 'Run'>
/** What a map has besides its raster, under the path of a run if there is one. */
export type GroundOf = (setup: RunSetup, run?: core.Run) => Ground | null

type Tick = Extract<PanelRequest, { kind: 'tick' }>

export interface Running {
  id: number
  run: core.Run
  stepper: Stepper
  /** With the first stops. */
  watch?: StopWatch
  rowsSent: number
  /** The best path's fingerprint at the last frame: it is sent again only when it has changed. */
  pathSent: string
  /** Counts what is to be shown, an iteration of the past or where the run stands: only the newest of them is. */
  looks: number
}

let engine: PanelEngine
let painter: Painter | null = null
let current: Running | null = null
let groundOf: GroundOf

/** Answers the page with this engine from now on. */
export function servePanel(build: PanelEngine, ground: GroundOf): void {
  engine = build
  groundOf = ground
  self.onmessage = (event: MessageEvent<PanelRequest>) => answer(event.data)
}

function init(request: Extract<PanelRequest, { kind: 'init' }>): void {
  engine.initSync({ module: request.module })
  painter = new Painter(request.canvas, request.view, (scale) => reply({ kind: 'scale', ...scale }))
  reply({ kind: 'ready' })
}

/** The old run goes only when the new one stands. */
function load(runId: number, setup: RunSetup): void {
  const { spec, cells, heights, factors, planner, params, seed, ahead } = setup
  const run = new engine.Run(spec, cells, heights, factors, planner, params, seed)
  run.keep_snapshots(KEPT_BYTES)
  if (ahead) run.advance('iteration', ahead)
  const old = current
  const stepper = new Stepper(run, () => performance.now())
  current = { id: runId, run, stepper, rowsSent: 0, pathSent: '', looks: 0 }
  painter?.show(run, spec, groundOf(setup, run))
  old?.run.free()
  reply(frame(current, true, 0))
}

/** A refused setup leaves the map, to be drawn on until it can run. */
function refuse(setup: RunSetup): void {
  const { spec, cells, heights, factors } = setup
  painter?.showMap(spec, groundOf(setup), (context, theme, shaded) =>
    engine.paint_map(context, spec, cells, heights, factors, theme, shaded),
  )
  current?.run.free()
  current = null
}

/** How a run is taken towards a target. */
type Advance = (running: Running, target: Target) => { reached: boolean; met?: Stop[] }

function tick({ runId, target, sliceMs }: Tick, advance?: Advance): void {
  if (current?.id !== runId) return
  leavePast(current)
  const began = performance.now()
  const { reached, met } = advance?.(current, target) ?? {
    reached: current.stepper.advance(target, sliceMs),
  }
  const workMs = performance.now() - began
  const answer = frame(current, reached, workMs)
  painter?.refresh(target.kind === 'moves' && target.count === 1)
  reply({ ...answer, met })
}

/** What stops a run is fetched with the first stop or question. */
async function tickWithStops(request: Tick, stops: Stop[]): Promise<void> {
  const { StopWatch } = await import('./panel_answers')
  tick(request, (running, target) => {
    running.watch ??= new StopWatch(running.run, () => performance.now())
    return running.watch.advance(target, request.sliceMs, stops)
  })
}

/** What has changed since the last frame; the painter shares the best path rather than asking for it twice. */
function frame(running: Running, reached: boolean, workMs: number): Frame {
  const { run, id } = running
  const history = run.history(running.rowsSent)
  running.rowsSent = run.history_rows()
  const path = run.best_path()
  painter?.setPath(path)
  const fingerprint = path.join()
  const changed = fingerprint !== running.pathSent
  running.pathSent = fingerprint
  const status: core.Status = run.status()
  const summary = run.summary()
  painter?.setOrder(summary.tour?.order ?? [])
  return {
    kind: 'frame',
    runId: id,
    status,
    summary,
    history,
    reached,
    bestPath: changed ? path : null,
    bestAltitudes: changed ? run.best_altitudes() : null,
    workMs,
  }
}

/** A run goes on from where it stands, whatever was looked at. */
function leavePast(running: Running): void {
  if (running.looks === 0) return
  running.looks++
  running.run.show_iteration(undefined, 0)
}

async function ask({ runId, id, question }: Extract<PanelRequest, { kind: 'ask' }>): Promise<void> {
  const running = current?.id === runId ? current : null
  if (running && question.about === 'look') running.looks++
  const answer = running && (await answerTo(question, running).catch(() => null))
  const transfer =
    answer instanceof Float32Array ? [answer.buffer] : answer instanceof ImageBitmap ? [answer] : []
  self.postMessage({ kind: 'answer', id, answer } satisfies PanelReply, { transfer })
}

/** The rarely asked questions are answered by a part that is fetched with the first of them. */
async function answerTo(question: PanelQuestion, running: Running) {
  const looks = running.looks
  const { answer } = await import('./panel_answers')
  return answer(question, running.run, {
    isCurrent: () => current === running && (question.about !== 'look' || running.looks === looks),
    painter,
  })
}

function raster(): void {
  const bitmap = painter?.flatBitmap()
  if (!bitmap) return
  const ants = current?.run.ants() ?? new Uint32Array()
  const message: PanelReply = { kind: 'raster', bitmap, ants }
  self.postMessage(message, { transfer: [bitmap] })
}

function reply(message: PanelReply): void {
  self.postMessage(message)
}

/** A promise where a part of the worker has to be fetched first. */
function handle(request: PanelRequest): Promise<void> | undefined {
  switch (request.kind) {
    case 'init':
      init(request)
      break
    case 'load':
      load(request.runId, request.setup)
      break
    case 'view':
      painter?.setView(request.view)
      break
    case 'tick':
      if (request.stops) return tickWithStops(request, request.stops)
      return painter?.afterView(() => tick(request))
    case 'raster':
      raster()
      break
    case 'ask':
      if (painter === null) return ask(request)
      return painter.afterView(() => void ask(request))
  }
}

async function answer(request: PanelRequest): Promise<void> {
  try {
    await handle(request)
  } catch (thrown) {
    if (isEngineError(thrown) && 'runId' in request) {
      if (request.kind === 'load') refuse(request.setup)
      reply({ kind: 'refused', runId: request.runId, error: thrown })
    } else {
      reply({
        kind: 'failed',
        error: crash(thrown instanceof Error ? thrown.message : String(thrown)),
      })
    }
  }
}
