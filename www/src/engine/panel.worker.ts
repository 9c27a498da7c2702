/** One panel: one engine instance, one canvas, at most one run. Everything it does answers a request (see messages.ts). */
import { initSync, Run, type Status } from '@pkg/core/formicarium'
import type { Frame, PanelReply, PanelRequest, RunSetup, Target } from '../messages'
import { Painter } from '../stage/painter'
import { isEngineError } from './errors'
import { Stepper } from './stepper'

interface Running {
  id: number
  run: Run
  stepper: Stepper
  rowsSent: number
  /** The best path's fingerprint at the last frame: it is sent again only when it has changed. */
  pathSent: string
}

let painter: Painter | null = null
let current: Running | null = null

function init(request: Extract<PanelRequest, { kind: 'init' }>): void {
  initSync({ module: request.module })
  painter = new Painter(request.canvas, request.view)
  reply({ kind: 'ready' })
}

/** The old run goes only when the new one stands: a refused setup leaves the panel showing what it showed. */
function load(runId: number, setup: RunSetup): void {
  const run = new Run(setup.spec, setup.cells, setup.planner, setup.params, setup.seed)
  const old = current
  const stepper = new Stepper(run, () => performance.now())
  current = { id: runId, run, stepper, rowsSent: 0, pathSent: '' }
  painter?.show(run, setup.spec)
  old?.run.free()
  reply(frame(current, true, 0))
}

function tick(runId: number, target: Target, sliceMs: number): void {
  if (current?.id !== runId) return
  const began = performance.now()
  const reached = current.stepper.advance(target, sliceMs)
  const workMs = performance.now() - began
  const answer = frame(current, reached, workMs)
  painter?.refresh(target.kind === 'moves' && target.count === 1)
  reply(answer)
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
  const status: Status = run.status()
  return {
    kind: 'frame',
    runId: id,
    status,
    summary: run.summary(),
    history,
    reached,
    bestPath: changed ? path : null,
    workMs,
  }
}

function reply(message: PanelReply): void {
  self.postMessage(message)
}

function handle(request: PanelRequest): void {
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
      tick(request.runId, request.target, request.sliceMs)
      break
  }
}

self.onmessage = (event: MessageEvent<PanelRequest>) => {
  const request = event.data
  try {
    handle(request)
  } catch (thrown) {
    if (isEngineError(thrown) && 'runId' in request) {
      reply({ kind: 'refused', runId: request.runId, error: thrown })
    } else {
      reply({ kind: 'crashed', message: thrown instanceof Error ? thrown.message : String(thrown) })
    }
  }
}
