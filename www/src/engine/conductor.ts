/** The animation-frame loop: posts each panel's next tick when all have answered the last. The work is done in the workers. */
import type { MetStop, Stop } from '../model/lesson'
import type { PanelReply, RunSetup, Target } from '../model/messages'
import { SPEEDS, type Speed, type Sync } from '../model/session'
import type { PanelClient } from './panel_client'
import { client, detach, ensure, listen } from './panel_clients'
import { Pace, planRound, SLICE_MS, sliceFor, standing } from './plan_round'

/** What the conductor reads from the page's state, and what it reports. */
export interface ConductorHost {
  panelIds(): number[]
  /** Index into SPEEDS. */
  speed(): number
  sync(): Sync
  /** Where the runs stop by themselves. */
  stops(): Stop[] | undefined
  onReply(panelId: number, reply: PanelReply): void
  /** Panels have met stops, and all stand still; none when something begins. */
  onMet(met: MetStop[]): void
  /** Every panel has ended or failed. Called once each time playing or stepping gets there. */
  onAllFinished(): void
}

export interface Conductor {
  /** Whether nothing is under way: not playing, and no step waits. */
  isIdle(): boolean
  /** Replaces a panel's run; the request waits until the panel's worker has started. */
  load(panelId: number, runId: number, setup: RunSetup): void
  /** Ends a panel's worker. */
  drop(panelId: number): void
  play(): void
  pause(): void
  step(by: 'move' | 'iteration'): void
  /** As fast as possible: in step to the first stop or, without stops or through all of them, each panel for itself. */
  runToEnd(through: boolean): void
}

type Mode = 'idle' | 'play' | 'step' | 'to-end'

const FULL_SPEED: Speed = { id: 'max', unit: 'max', count: 1, everyFrames: 1 }

export function createConductor(host: ConductorHost): Conductor {
  return new FrameLoop(host)
}

class FrameLoop implements Conductor {
  private mode: Mode = 'idle'
  private requested = 0
  private frames = 0
  /** Targets of the present round that have not been reached yet. */
  private round = new Map<number, Target>()
  private slowestMs = 0
  private pace = new Pace()
  private steps: ('move' | 'iteration')[] = []
  /** Stops do not count. */
  private through = false
  private met: MetStop[] = []
  /** Rounds that may follow in the same frame. */
  private more = 0

  constructor(private readonly host: ConductorHost) {
    listen((panelId, reply) => this.receive(panelId, reply))
  }

  isIdle(): boolean {
    return this.mode === 'idle'
  }

  load(panelId: number, runId: number, setup: RunSetup): void {
    this.round.delete(panelId)
    ensure(panelId).load(runId, setup)
  }

  drop(panelId: number): void {
    this.round.delete(panelId)
    detach(panelId)
  }

  play(): void {
    this.begin('play')
  }

  runToEnd(through: boolean): void {
    this.begin('to-end', through)
  }

  /** Ticks under way end with their slice and are still answered. */
  pause(): void {
    this.mode = 'idle'
    this.steps = []
    this.more = 0
    this.round.clear()
    cancelAnimationFrame(this.requested)
  }

  /** Steps are queued when they are asked for faster than they are done. */
  step(by: 'move' | 'iteration'): void {
    this.steps.push(by)
    if (this.mode !== 'step') this.begin('step')
  }

  private begin(mode: Mode, through = false): void {
    this.mode = mode
    this.through = through
    this.met = []
    this.host.onMet([])
    this.frames = 0
    this.round.clear()
    this.pace = new Pace()
    this.request()
  }

  private request(): void {
    cancelAnimationFrame(this.requested)
    this.requested = requestAnimationFrame(() => this.onFrame())
  }

  private onFrame(): void {
    if (this.mode === 'idle') return
    this.request()
    const { unit, count } = this.speed()
    // Where stops keep rounds small: as many as the speed counts, or as fit.
    this.more = this.stops() ? (unit === 'max' ? 1e9 : count) : 0
    this.goOn()
  }

  /** Ticks what has not reached its target, or plans the next round. */
  private goOn(): void {
    const panels = this.panels()
    if (panels.some((panel) => panel.client.state === 'loading')) return
    const running = panels.filter(({ client }) => client.state !== 'failed' && !client.finished)
    if (running.length === 0) this.finish()
    else if (this.round.size > 0 || this.nextRound(running)) this.tick()
  }

  private panels(): { id: number; client: PanelClient }[] {
    return this.host.panelIds().flatMap((id) => {
      const found = client(id)
      return found ? [{ id, client: found }] : []
    })
  }

  /** Plans the next round when it is due; false when this frame has none. */
  private nextRound(running: { id: number; client: PanelClient }[]): boolean {
    if (running.some(({ client }) => client.state === 'ticking')) return false
    if (this.met.length > 0) return this.stop()
    const standings = running.flatMap(({ id, client }) =>
      client.frame ? [standing(id, client.frame)] : [],
    )
    if (this.mode === 'step') {
      const by = this.steps.shift()
      if (by === undefined) return this.rest()
      this.round = planRound(standings, { ...FULL_SPEED, unit: by }, 'moves', 1)
      return true
    }
    // Wherever they stop, all panels are to stand at the same move or iteration: so rounds are the smallest there are.
    const stops = this.stops()
    if (this.mode === 'to-end' && !stops) {
      this.round = planRound(standings, FULL_SPEED, 'time', 1)
      return true
    }
    const speed = this.speed()
    if (this.frames++ % speed.everyFrames !== 0) return false
    this.pace.finish(this.slowestMs)
    this.slowestMs = 0
    const pace = stops ? { ...speed, count: 1 } : speed
    this.round = planRound(standings, pace, this.host.sync(), stops ? 1 : this.pace.batch)
    return true
  }

  private tick(): void {
    const sliceMs = this.mode === 'play' ? sliceFor(this.speed(), this.host.sync()) : SLICE_MS
    const stops = this.stops()
    for (const [id, target] of this.round) client(id)?.tick(target, sliceMs, stops)
  }

  private stops(): Stop[] | undefined {
    return this.through ? undefined : this.host.stops()
  }

  private speed(): Speed {
    return (this.mode === 'play' && SPEEDS[this.host.speed()]) || FULL_SPEED
  }

  private receive(panelId: number, reply: PanelReply): void {
    if (reply.kind === 'frame') {
      this.slowestMs = Math.max(this.slowestMs, reply.workMs)
      if (reply.reached) this.round.delete(panelId)
      for (const stop of reply.met ?? []) this.met.push({ panelId, stop })
    } else if (reply.kind !== 'ready') this.round.delete(panelId)
    this.host.onReply(panelId, reply)
    // What a pause has overtaken is said all the same.
    if (this.mode === 'idle' && this.met.length > 0) this.stop()
    if (this.round.size === 0 && --this.more > 0) this.goOn()
  }

  private stop(): false {
    const { met } = this
    this.met = []
    this.pause()
    this.host.onMet(met)
    return false
  }

  private rest(): false {
    this.mode = 'idle'
    return false
  }

  private finish(): void {
    this.stop()
    this.host.onAllFinished()
  }
}
