/**
 * The cursor of a chart: it stops at places of the axis, by pointer or keys. A press acts where it stands, a drag zooms in, a double
 * click shows all again.
 */
import { type Signal, signal } from '@preact/signals'
import type uPlot from 'uplot'

type Range = [from: number, to: number]

export interface Places {
  /** The first and the last place of the axis. */
  ends(): Range
  /** The place nearest to a value of the axis. */
  nearest(x: number): number
  /** The place so many steps away. */
  step(from: number, by: number): number
  /** Where keys begin. */
  start(): number
  /** What a press does. */
  act(place: number): void
}

/** Pixels from which on a drag is one. */
const DRAG = 5
/** While zoomed in, a press waits as long for a second one, which means something else. */
const DOUBLE_MS = 300
/** What one key zooms. */
const ZOOM = 2

export class ChartCursor {
  /** Where it stands; null while it is not on the chart. */
  readonly at: Signal<number | null> = signal(null)
  /** The part of the axis on show; null for all of it. */
  readonly zoom: Signal<Range | null> = signal(null)
  private plot: uPlot | null = null
  private byKeys = false
  private dragged = false
  private press = 0
  private readonly line = document.createElement('div')

  constructor(private readonly places: Places) {}

  /** What a plot needs to have it. */
  readonly plugin: uPlot.Plugin = {
    opts: (_, options) => ({
      ...options,
      cursor: {
        // The line stands at a place, the library's where the pointer is.
        x: false,
        y: false,
        points: { show: false },
        drag: { x: true, y: false, dist: DRAG, setScale: false, click: () => {} },
        bind: { dblclick: () => null },
      },
    }),
    hooks: {
      init: (plot) => this.listen(plot),
      setCursor: (plot) => this.moved(plot),
      setSelect: (plot) => this.selected(plot),
      draw: () => this.mark(),
      destroy: () => this.forget(),
    },
  }

  /** Of the axis that it moves along. */
  readonly range: uPlot.Range.Function = (_, min, max) => this.zoom.peek() ?? [min ?? 1, max ?? 10]

  /** After the plot has got other values: what keys have chosen stays chosen. */
  refresh(): void {
    const { at, plot } = this
    if (plot && this.byKeys && at.value !== null) this.place(at.value)
  }

  reset(): void {
    this.show(null)
  }

  readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.plot) return
    const done = this.move(event) || this.does(event.key)
    if (done) event.preventDefault()
  }

  private listen(plot: uPlot): void {
    this.plot = plot
    this.line.className = 'chart-cursor'
    plot.over.append(this.line)
    plot.over.addEventListener('mousedown', () => {
      this.dragged = false
    })
    plot.over.addEventListener('click', (event) => this.pressed(plot, event))
    plot.over.addEventListener('dblclick', () => {
      clearTimeout(this.press)
      this.reset()
    })
  }

  private forget(): void {
    clearTimeout(this.press)
    this.plot = null
  }

  /** The line across the plot. */
  private mark(): void {
    const { plot, line, at } = this
    const place = at.peek()
    const left = plot && place !== null ? plot.valToPos(place, 'x') : -1
    const within = plot !== null && left >= 0 && left <= plot.over.clientWidth
    line.hidden = !within
    line.style.left = `${left}px`
  }

  private moved(plot: uPlot): void {
    const { left = -1, event } = plot.cursor
    if (event) this.byKeys = false
    // What keys have chosen is known; its pixel may be one of an axis that has grown since.
    if (!this.byKeys)
      this.at.value = left < 0 ? null : this.places.nearest(plot.posToVal(left, 'x'))
    this.mark()
  }

  private pressed(plot: uPlot, { clientX }: MouseEvent): void {
    if (this.dragged) return
    // The cursor comes a frame later.
    const left = clientX - plot.over.getBoundingClientRect().left
    const place = this.places.nearest(plot.posToVal(left, 'x'))
    clearTimeout(this.press)
    if (this.zoom.peek() === null) this.places.act(place)
    else this.press = window.setTimeout(() => this.places.act(place), DOUBLE_MS)
  }

  private selected(plot: uPlot): void {
    const { left, width } = plot.select
    if (width <= 0) return
    this.dragged = true
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false)
    this.show([plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x')])
  }

  private show(range: Range | null): void {
    this.zoom.value = range && this.fitting(range)
    // The axes ask for their ranges anew.
    if (this.plot) this.plot.setData(this.plot.data)
    this.refresh()
  }

  /** Inside the axis, and never so narrow that two neighbours are not on show; null where that is all of it. */
  private fitting([from, to]: Range): Range | null {
    const [first, last] = this.places.ends()
    const low = this.places.nearest(Math.max(first, from))
    const high = Math.max(this.places.nearest(Math.min(last, to)), this.places.step(low, 1))
    return low <= first && high >= last ? null : [low, high]
  }

  private move({ key, shiftKey }: KeyboardEvent): boolean {
    const { places } = this
    const from = this.at.peek() ?? places.start()
    const [first, last] = places.ends()
    const tenth = Math.max(1, Math.round((last - first) / 10))
    const by = shiftKey ? 10 : 1
    const targets: Record<string, () => number> = {
      ArrowLeft: () => places.step(from, -by),
      ArrowRight: () => places.step(from, by),
      PageDown: () => places.nearest(Math.max(first, from - tenth)),
      PageUp: () => places.nearest(Math.min(last, from + tenth)),
      Home: () => first,
      End: () => last,
    }
    const to = targets[key]?.()
    if (to === undefined) return false
    this.byKeys = true
    this.at.value = to
    this.bringIn(to)
    this.place(to)
    return true
  }

  private does(key: string): boolean {
    const at = this.at.peek() ?? this.places.start()
    if (key === 'Enter') this.places.act(at)
    else if (key === '+' || key === '=') this.zoomAbout(at, 1 / ZOOM)
    else if (key === '-') this.zoomAbout(at, ZOOM)
    else if ((key === 'Escape' || key === '0') && this.zoom.peek()) this.reset()
    else return false
    return true
  }

  private zoomAbout(at: number, factor: number): void {
    const [from, to] = this.zoom.peek() ?? this.places.ends()
    this.show([at - (at - from) * factor, at + (to - at) * factor])
  }

  /** Moves the part on show as far as it takes. */
  private bringIn(place: number): void {
    const now = this.zoom.peek()
    if (!now || (place >= now[0] && place <= now[1])) return
    const shift = place < now[0] ? place - now[0] : place - now[1]
    this.show([now[0] + shift, now[1] + shift])
  }

  private place(at: number): void {
    this.plot?.setCursor({ left: this.plot.valToPos(at, 'x'), top: 0 })
  }
}
