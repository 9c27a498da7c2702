/** An order problem on show: its facts, and the run of the order colony that can be watched. */
import type { EngineError, OrderBound, OrderFacts, OrderSummary } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { newOrderBox, type OrderBox } from '../engine/order_box'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { describeError } from '../i18n/errors'
import type { ParamValues } from '../model/messages'
import type { OrderSettings } from '../model/order_calls'
import { openDialog, show } from './dialogs'
import { fileName } from './file_paths'
import type { NamedBytes } from './offered_files'

/** A whole run takes this many frames or fewer. */
const FRAMES = 400
/** Of a frame so much is the worker's. */
const SLICE = 25

/** The best of the ants, the one of a file, the proven one, or that of the search for a proof. */
export type ShownTour = 'ants' | 'tour' | 'exact' | 'search'

export class OrderPlay {
  readonly facts = signal<OrderFacts>(null as never)
  readonly summary = signal<OrderSummary | null>(null)
  /** What a search from the best tour on has proven; it follows the run. */
  readonly bound = signal<OrderBound | null>(null)
  /** From, to, share of the largest; null while they are not shown. */
  readonly trails = signal<Float64Array | null>(null)
  readonly running = signal(false)
  /** Which tour is drawn. */
  readonly shown = signal<ShownTour>('ants')
  readonly error = signal<unknown>(null)
  readonly settings = signal<OrderSettings>({ open: false, seed: 1, params: {} })
  /** Answers to what was asked in an earlier turn are dropped. */
  private turn = 0

  private constructor(
    readonly instance: NamedBytes,
    public tour: NamedBytes | null,
    private readonly box: OrderBox,
  ) {}

  /** Reads the problem; what cannot be read is thrown. */
  static async of(instance: NamedBytes, tour: NamedBytes | null): Promise<OrderPlay> {
    const box = newOrderBox()
    const play = new OrderPlay(instance, tour, box)
    try {
      play.facts.value = await play.read(false, tour)
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
    this.bound.value = null
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
    await this.prove(turn)
  }

  async step(): Promise<void> {
    this.running.value = false
    const { turn } = this
    await this.advance(turn, 1)
    await this.prove(turn)
  }

  /** Once the run is over: the search for a proof, until it is at its end or another run begins. */
  private async prove(turn: number): Promise<void> {
    try {
      while (turn === this.turn && this.isFinished() && !this.bound.peek()?.finished) {
        const bound = await this.box.call('searchOrder', SLICE)
        if (turn !== this.turn || bound === null) return
        this.bound.value = bound
        await new Promise(requestAnimationFrame)
      }
    } catch (error) {
      if (turn === this.turn) this.error.value = error
    }
  }

  end(): void {
    this.running.value = false
    this.turn++
    this.box.terminate()
  }

  /** Another tour beside the run, which stays; one that does not fit is thrown, and changes nothing. */
  async takeTour(tour: NamedBytes): Promise<void> {
    const facts = await this.read(this.settings.peek().open, tour)
    this.tour = tour
    this.facts.value = facts
    this.shown.value = 'tour'
  }

  private async readAgain(open: boolean): Promise<void> {
    this.facts.value = await this.read(open, this.tour)
  }

  /** Where the instance alone can be read, the tour is at fault, and its file is named. */
  private async read(open: boolean, tour: NamedBytes | null): Promise<OrderFacts> {
    const { bytes } = this.instance
    try {
      return await this.box.call('readOrder', bytes, open, tour?.bytes ?? null)
    } catch (error) {
      if (tour === null) throw error
      await this.box.call('readOrder', bytes, open, null)
      throw tourUnfit(tour.name, error)
    }
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

function tourUnfit(file: string, error: unknown): EngineError {
  const { message, hint } = describeError(error)
  const told = t('order.tourUnfit', { file, message })
  return { kind: 'tour-unfit', field: file, message: told, hint, args: {} }
}

/**
 * Opens the dialog of an instance, and of a tour of it. The map stays. `check` throws where it is no longer wanted once it has been
 * read.
 */
export async function offerOrder(
  instance: NamedBytes,
  tour: NamedBytes | null,
  check: () => void,
): Promise<void> {
  const play = await OrderPlay.of(instance, tour)
  try {
    check()
  } catch (over) {
    play.end()
    throw over
  }
  orderPlay.peek()?.end()
  orderPlay.value = play
  show('order')
}

/** Shows the tour that came beside the problem on show. Null: no problem is on show, or no single tour came. */
export async function takeTour(given: NamedBytes[]): Promise<NamedBytes | null> {
  const play = orderPlay.peek()
  if (!play || openDialog.peek() !== 'order') return null
  const tours: NamedBytes[] = []
  for (const file of given)
    if ((await tools.recognise(file.bytes, file.name)).kind === 'tsplib-tour') tours.push(file)
  const [tour, second] = tours
  if (!tour || second) return null
  await play.takeTour({ name: fileName(tour.name), bytes: tour.bytes })
  return tour
}
