/**
 * Keeps one panel's picture, in layers, each made anew only when it has changed: the raster that the engine paints; in the view what
 * lies on the ground, which is the raster, lines and the best path; and over it ants, marks and cursor. Lives in the worker.
 */
import type { Run } from '@pkg/core/formicarium'
import type { ScenarioSpec } from '@pkg/formicarium'
import { drawCursor, drawGrid, drawHatch, drawPath, drawRaster } from '../drawing/draw_map'
import { drawMarks } from '../drawing/draw_marks'
import type { LayerScale, PanelView } from '../model/messages'
import { Crowd } from './crowd'
import { drawCrowd } from './draw_crowd'
import { paintLayer, pictureOf } from './shown_layer'

type Context = OffscreenCanvasRenderingContext2D

/** What lies on a map besides its raster. Only the whole engine has any. */
export interface Ground {
  /** Whether some cells have no data. */
  readonly hasHoles: boolean
  /** Contour lines; `again` is called when there is a better picture. */
  draw(context: Context, view: PanelView, again: () => void): void
  /** What lies over the best path. */
  drawOver?(context: Context, view: PanelView): void
}

type PaintMap = (context: Context, theme: PanelView['theme'], shaded: boolean) => void

/** Slow steps are shown as a walk rather than a jump, but never longer than this. */
const LONGEST_GLIDE_MS = 140
/** Steps that follow each other faster than this need no walk in between. */
const SHORTEST_GLIDE_MS = 24

export class Painter {
  private readonly context: Context
  private raster: Context | null = null
  /** Which picture the raster has. */
  private painted = ''
  /** What lies on the ground, as large as the view, and of what it was drawn. */
  private readonly ground = contextOf(new OffscreenCanvas(1, 1))
  private grounded = ''
  private run: Run | null = null
  /** Paints the map where there is no run. */
  private bare: PaintMap | null = null
  private spec: ScenarioSpec | null = null
  private onGround: Ground | null = null
  private path: Uint32Array = new Uint32Array()
  /** For each goal its place in the order of visits, from 1. */
  private places: number[] = []
  private readonly crowd = new Crowd()
  private lastStep = 0
  private glideFrom = 0
  private glideMs = 0
  /** How far ants are through their last move, where no clock is to tell. */
  declare glide: number | undefined
  private requested = 0
  /** What is to be done once the view that was given last has been drawn; null when it has. */
  private waiting: (() => void)[] | null = null
  private scale = ''

  constructor(
    readonly canvas: OffscreenCanvas,
    public view: PanelView,
    /** Told what the colours mean when it has changed. */
    private readonly onScale: (scale: LayerScale) => void,
  ) {
    this.context = contextOf(canvas)
  }

  /** Shows another run from now on. */
  show(run: Run, spec: ScenarioSpec, onGround: Ground | null): void {
    this.run = run
    this.begin(spec, onGround)
  }

  /** Shows a map with its marks, and no run, from now on. */
  showMap(spec: ScenarioSpec, onGround: Ground | null, paint: PaintMap): void {
    this.run = null
    this.bare = paint
    this.begin(spec, onGround)
  }

  private begin(spec: ScenarioSpec, onGround: Ground | null): void {
    this.spec = spec
    this.onGround = onGround
    this.painted = ''
    this.setPath(new Uint32Array())
    this.places = []
    this.crowd.clear()
    this.glideMs = 0
    if (this.raster?.canvas.width !== spec.width || this.raster.canvas.height !== spec.height) {
      this.raster = contextOf(new OffscreenCanvas(spec.width, spec.height))
    }
    this.draw()
  }

  /** x0, y0, x1, y1, …; shown from the next drawing on. */
  setPath(path: Uint32Array): void {
    if (path.length !== this.path.length || path.some((value, i) => value !== this.path[i]))
      this.grounded = ''
    this.path = path
  }

  /** The goals' indices in visiting order; shown from the next drawing on. */
  setOrder(order: readonly number[]): void {
    this.places = []
    for (const [place, goal] of order.entries()) this.places[goal] = place + 1
  }

  /** The run has moved on. `single`: by one move, so that every ant went one cell at most. */
  refresh(single: boolean): void {
    if (this.run === null) return
    this.crowd.update(this.run.ants(), single)
    const now = performance.now()
    const since = now - this.lastStep
    this.lastStep = now
    this.glideFrom = now
    this.glideMs = single && since > SHORTEST_GLIDE_MS ? Math.min(since, LONGEST_GLIDE_MS) : 0
    this.draw()
  }

  setView(view: PanelView): void {
    this.view = view
    if (this.waiting) return
    this.waiting = []
    // Of views that have come together the last one is drawn.
    setTimeout(() => this.drawView())
  }

  /**
   * Does something at once or, where a view waits to be drawn, after that: a reader who moves the map waits for no step of a planner. The
   * promise tells when it is done, and what it throws.
   */
  afterView(what: () => void): Promise<void> | undefined {
    const { waiting } = this
    if (waiting) return new Promise<void>((resolve) => waiting.push(resolve)).then(what)
    what()
    return undefined
  }

  private drawView(): void {
    const waiting = this.waiting ?? []
    this.waiting = null
    try {
      this.draw()
    } finally {
      for (const go of waiting) go()
    }
  }

  /** The map and its layer as they stand, one pixel a cell, without light and shade; null before the first map. */
  flatBitmap(): ImageBitmap | null {
    if (this.spec === null) return null
    const canvas = new OffscreenCanvas(this.spec.width, this.spec.height)
    this.paint(contextOf(canvas), false)
    return canvas.transferToImageBitmap()
  }

  private repaint(): void {
    const { run, view, raster } = this
    if (raster === null || view.hidden) return
    const picture = run ? pictureOf(run, view) : view.theme
    if (picture === this.painted) return
    this.painted = picture
    this.grounded = ''
    this.paint(raster, true)
  }

  private paint(onto: Context, shaded: boolean): void {
    const { run, view } = this
    if (run === null) this.bare?.(onto, view.theme, shaded)
    this.tell(run ? paintLayer(run, onto, view, shaded) : { layer: 'none', own: null })
  }

  private tell(scale: LayerScale): void {
    const key = `${scale.layer} ${scale.own}`
    if (key !== this.scale) this.onScale(scale)
    this.scale = key
  }

  draw(): void {
    const { context, view, spec, raster } = this
    fit(this.canvas, view)
    if (view.hidden || view.width === 0 || view.height === 0) return
    if (spec === null || raster === null) {
      context.clearRect(0, 0, view.width, view.height)
      return
    }
    this.repaint()
    this.drawGround(spec, raster)
    context.globalCompositeOperation = 'copy'
    context.drawImage(this.ground.canvas, 0, 0)
    context.globalCompositeOperation = 'source-over'
    if (view.showAnts) this.drawAnts(spec)
    drawMarks(context, view, spec, this.places)
    drawCursor(context, view)
  }

  private drawGround(spec: ScenarioSpec, raster: Context): void {
    const { ground, view, onGround } = this
    const { cursor, cursorFocus, showAnts, goalNames, ...seen } = view
    const now = JSON.stringify(seen)
    if (now === this.grounded) return
    this.grounded = now
    fit(ground.canvas, view)
    ground.clearRect(0, 0, view.width, view.height)
    if (onGround?.hasHoles || spec.robot) drawHatch(ground, view, spec)
    drawRaster(ground, view, raster.canvas)
    if (view.showContours) onGround?.draw(ground, view, () => this.drawAnew())
    drawGrid(ground, view, spec)
    if (!view.showPath) return
    drawPath(ground, view, this.path)
    onGround?.drawOver?.(ground, view)
  }

  private drawAnew(): void {
    this.grounded = ''
    this.draw()
  }

  private drawAnts({ goals }: ScenarioSpec): void {
    const since = performance.now() - this.glideFrom
    const progress = this.glide ?? (this.glideMs > 0 ? since / this.glideMs : 1)
    drawCrowd(this.context, this.view, this.crowd.underWay(goals), Math.min(1, progress))
    cancelAnimationFrame(this.requested)
    if (progress < 1 && this.crowd.size > 0)
      this.requested = requestAnimationFrame(() => this.draw())
  }
}

function fit(canvas: OffscreenCanvas, { width, height }: PanelView): void {
  if (canvas.width !== width) canvas.width = width
  if (canvas.height !== height) canvas.height = height
}

function contextOf(canvas: OffscreenCanvas): Context {
  const context = canvas.getContext('2d')
  if (context === null) throw new Error('this browser offers no 2D canvas in workers')
  return context
}
