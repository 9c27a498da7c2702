/** A copy of a panel's run, in a worker of its own: the run on the page knows nothing of it. */
import type { Smoothed } from '@pkg/formicarium'
import { PanelClient } from '../engine/panel_client'
import { crash } from '../model/errors'
import type { Frame, PanelReply, PanelView, RunSetup, Target } from '../model/messages'

/** Long enough to be quick, short enough that a film that is given up ends soon. */
const SLICE_MS = 60

export class RunCopy {
  frame: Frame | null = null
  /** x0, y0, x1, y1, …; empty while there is none. */
  path: Uint32Array = new Uint32Array()
  private readonly client = new PanelClient((reply) => this.receive(reply))
  private waiting: { resolve(frame: Frame): void; reject(error: unknown): void } | null = null

  constructor(
    /** Told the rows that a run's history has grown by. */
    private readonly onHistory: (rows: Float64Array) => void = () => {},
  ) {}

  load(setup: RunSetup): Promise<Frame> {
    return this.answered(() => this.client.load(1, setup))
  }

  /** Goes on until the target is reached or the run has ended. */
  async advance(target: Target): Promise<void> {
    while (this.frame?.status === 'running') {
      const { reached } = await this.answered(() => this.client.tick(target, SLICE_MS))
      if (reached) return
    }
  }

  /** What this view shows now. */
  async shot(view: PanelView, glide: number): Promise<ImageBitmap> {
    const bitmap = await this.client.ask({ about: 'shot', view, glide })
    if (!bitmap) throw crash('the worker has drawn nothing')
    return bitmap
  }

  /** The map and its layer, one pixel a cell. */
  picture(view: Pick<PanelView, 'layer' | 'ends' | 'theme'>, size: [number, number]) {
    return this.client.ask({ about: 'picture', size, ...view })
  }

  async curve(): Promise<Smoothed | null> {
    return (await this.client.ask({ about: 'curve' }))?.curve ?? null
  }

  end(): void {
    this.client.terminate()
    this.waiting?.reject(crash('the copy of the run has been ended'))
  }

  private answered(ask: () => void): Promise<Frame> {
    return new Promise((resolve, reject) => {
      this.waiting = { resolve, reject }
      ask()
    })
  }

  private receive(reply: PanelReply): void {
    if (reply.kind === 'frame') {
      this.frame = reply
      this.path = reply.bestPath ?? this.path
      this.onHistory(reply.history)
      this.waiting?.resolve(reply)
    } else if (reply.kind === 'refused') this.waiting?.reject(reply.error)
    else if (reply.kind === 'failed') this.waiting?.reject(reply.error)
  }
}
