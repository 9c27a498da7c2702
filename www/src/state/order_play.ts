/** An order problem on show: its facts, and the run of the order colony that can be watched. */
import type { OrderFacts, OrderSummary } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { newOrderBox, type OrderBox } from '../engine/order_box'
import type { ParamValues } from '../model/messages'
import type { OrderSettings } from '../model/order_calls'
import { show } from './dialogs'
import type { NamedBytes } from './offered_files'

/** A whole run takes this many frames or fewer. */
const FRAMES = 400
/** Of a frame so much is the worker's. */
const SLICE = 25

export class OrderPlay {
  readonly facts = signal<OrderFacts>(null as never)
  readonly summary = signal<OrderSummary | null>(null)
  /** From, to, share of the largest; null while they are not shown. */
  readonly trails = signal<Float64Array | null>(null)
  readonly running = signal(false)
  readonly error = signal<unknown>(null)
  readonly settings = signal<OrderSettings>({ open: false, seed: 1, params: {} })
  /** Answers to what was asked in an earlier turn are dropped. */
  private turn = 0

  private constructor(
    readonly instance: NamedBytes,
    readonly tour: NamedBytes | null,
    private readonly box: OrderBox,
  ) {}

  /** Reads the problem; what cannot be read is thrown. */
  static async of(instance: NamedBytes, tour: NamedBytes | null): Promise<OrderPlay> {
    const box = newOrderBox()
    const play = new OrderPlay(instance, tour, box)
    try {
      play.facts.value = await box.call('readOrder', instance.bytes, false, tour?.bytes ?? null)
    } catch (error) {
      box.terminate()
      throw error
    }
    const defaults = play.facts.value.params.map(({ key, default: value }) => [key, value])
    play.settings.value = { open: false, seed: 1, params: Object.fromEntries(defaults) }
    await play.restart()
    return play
  }

  /** A run from the beginning, at rest. */
  async restart(): Promise<void> {
    this.running.value = false
    const settings = this.settings.peek()
    const turn = ++this.turn
    await this.answer(turn, this.box.call('startOrder', this.instance.bytes, settings))
  }

  async set(change: Partial<OrderSettings>): Promise<void> {
    const before = this.settings.peek()
    this.settings.value = { ...before, ...change }
    if (change.open !== undefined && change.open !== before.open) await this.readAgain(change.open)
    await this.restart()
  }

  setParam = (key: string, value: ParamValues[string]) =>
    this.set({ params: { ...this.settings.peek().params, [key]: value } })

  async toggleTrails(): Promise<void> {
    this.trails.value = this.trails.peek() ? null : await this.box.call('orderTrails')
  }

  isFinished(): boolean {
    const summary = this.summary.value
    return summary !== null && summary.iteration >= summary.budget
  }

  /** Runs on, or pauses; after the end, from the beginning. */
  async toggle(): Promise<void> {
    if (this.running.peek()) {
      this.running.value = false
      return
    }
    if (this.isFinished()) await this.restart()
    if (this.error.peek() !== null) return
    const turn = ++this.turn
    this.running.value = true
    const count = Math.ceil((this.summary.peek()?.budget ?? 1) / FRAMES)
    while (turn === this.turn && this.running.peek()) {
      await this.advance(turn, count)
      if (turn === this.turn && this.isFinished()) this.running.value = false
      await new Promise(requestAnimationFrame)
    }
  }

  async step(): Promise<void> {
    this.running.value = false
    await this.advance(this.turn, 1)
  }

  end(): void {
    this.running.value = false
    this.turn++
    this.box.terminate()
  }

  private async readAgain(open: boolean): Promise<void> {
    const { bytes } = this.instance
    this.facts.value = await this.box.call('readOrder', bytes, open, this.tour?.bytes ?? null)
  }

  private advance(turn: number, count: number): Promise<void> {
    return this.answer(turn, this.box.call('advanceOrder', count, SLICE))
  }

  private async answer(turn: number, asked: Promise<OrderSummary>): Promise<void> {
    try {
      const summary = await asked
      const trails = this.trails.peek() && (await this.box.call('orderTrails'))
      if (turn !== this.turn) return
      this.summary.value = summary
      this.trails.value = trails
      this.error.value = null
    } catch (error) {
      if (turn !== this.turn) return
      this.running.value = false
      this.summary.value = null
      this.error.value = error
    }
  }
}

/** The problem whose dialog is open. */
export const orderPlay = signal<OrderPlay | null>(null)

/** Opens the dialog of an instance, and of a tour of it. The map stays. */
export async function offerOrder(instance: NamedBytes, tour: NamedBytes | null): Promise<void> {
  const play = await OrderPlay.of(instance, tour)
  orderPlay.peek()?.end()
  orderPlay.value = play
  show('order')
}
