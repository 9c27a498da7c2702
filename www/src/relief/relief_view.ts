/** One panel in three dimensions: fetches its picture from its worker, and draws when something it shows has changed. */
import { computed, effect, type ReadonlySignal } from '@preact/signals'
import type { PanelClient, RasterWatcher } from '../engine/panel_client'
import { ensure } from '../engine/panel_clients'
import type { Cell } from '../model/cell'
import type { RasterReply } from '../model/messages'
import { sendOnceAFrame } from '../stage/once_a_frame'
import { type CanvasSize, type Cursor, lookAt } from '../stage/panel_view'
import { pointedCell } from '../stage/pointed_places'
import { panelById, panelColour, scenario, showAnts, shownOf, showPath, theme } from '../state'
import { leaveRelief, showContours } from '../state/relief'
import { cancelDraw, drawSoon } from './draw_queue'
import { eye } from './eye'
import { drawOverlay, type Scene } from './marks_overlay'
import { PanelCamera } from './panel_camera'
import { PanelContent } from './panel_content'
import { acquireRenderer, releaseRenderer, type SharedRenderer } from './shared_renderer'
import { ground, stretch } from './shown_ground'

/** While runs play, the picture on the ground is updated at most this often. */
const RASTER_EVERY_MS = 350
/** And it waits this many times as long as its drawing takes: the page has other work. */
const PATIENCE = 8
/** A machine that takes longer draws coarsely while the map is turned, and finely when it rests. */
const SLOW_MS = 45
const REST_MS = 220
const MOST_DPR = 2

export class ReliefView implements RasterWatcher {
  readonly camera = new PanelCamera()
  private readonly canvas = newCanvas()
  private readonly overlay = newCanvas()
  private readonly content = new PanelContent()
  private readonly renderer: SharedRenderer
  private readonly client: PanelClient
  private readonly stops: (() => void)[] = []
  // Much of what a run reports changes several times a second; its best path seldom does.
  private readonly shown = computed(() => {
    const panel = panelById(this.panelId)
    return panel && shownOf(panel)
  })
  private readonly bestPath = computed(() => this.shown.value?.bestPath)
  private readonly bestAltitudes = computed(() => this.shown.value?.bestAltitudes)
  private readonly order = computed(() => (this.shown.value?.summary?.tour?.order ?? []).join())
  private ants: Uint32Array = new Uint32Array()
  private asked = false
  private askedAt = 0
  private askTimer = 0
  private restTimer = 0
  private drawMs = 0
  /** Of canvas pixels per device pixel; less than 1 while it is turned on a slow machine. */
  private fineness = 1
  private readonly draw = () => this.drawGround()
  private readonly drawMarks = () => this.drawOverlay()

  /** Throws where the browser offers no WebGL. */
  constructor(
    private readonly panelId: number,
    host: HTMLElement,
    private readonly size: ReadonlySignal<CanvasSize>,
    private readonly cursor: ReadonlySignal<Cursor | null>,
  ) {
    this.renderer = acquireRenderer(() => leaveRelief('lost'))
    this.client = ensure(panelId)
    host.append(this.canvas, this.overlay)
    this.follow()
    this.client.watch(this)
  }

  dispose(): void {
    this.client.watch(null)
    for (const stop of this.stops) stop()
    clearTimeout(this.askTimer)
    clearTimeout(this.restTimer)
    cancelDraw(this.draw)
    cancelDraw(this.drawMarks)
    this.content.dispose()
    this.canvas.remove()
    this.overlay.remove()
    releaseRenderer()
  }

  stale(): void {
    if (this.asked || this.askTimer !== 0) return
    const every = Math.max(RASTER_EVERY_MS, PATIENCE * this.drawMs)
    const wait = Math.max(0, this.askedAt + every - performance.now())
    this.askTimer = window.setTimeout(() => {
      this.askTimer = 0
      this.askedAt = performance.now()
      this.asked = this.client.askRaster()
      if (!this.asked) this.stale()
    }, wait)
  }

  take({ bitmap, ants }: RasterReply): void {
    this.asked = false
    this.ants = ants
    this.content.setPicture(bitmap)
    this.placeAnts()
    drawSoon(this.draw)
  }

  /** What is on the overlay, and where; null before there is a terrain. */
  scene(): Scene | null {
    const [now, surface] = [scenario.value, ground.value]
    if (!now?.heights || !surface) return null
    const places: number[] = []
    const order = this.order.value === '' ? [] : this.order.value.split(',').map(Number)
    for (const [place, goal] of order.entries()) places[goal] = place + 1
    return { scenario: now, ground: surface, camera: this.camera, stretch: stretch.value, places }
  }

  get zoom(): number {
    return eye.peek().zoom
  }

  /** The cell that is seen at a point of the stage, in device pixels. */
  cellAt(at: [number, number]): Cell | null {
    const scene = this.scene()
    if (!scene) return null
    const { width, height } = this.size.peek()
    this.camera.aim(eye.peek(), scene.ground, scene.stretch, width, height)
    const hit = scene.ground.hit(this.camera.position, this.camera.ray(at), scene.stretch)
    if (!hit) return null
    const { width: columns, height: rows } = scene.ground
    return [Math.min(columns - 1, Math.floor(hit[0])), Math.min(rows - 1, Math.floor(hit[2]))]
  }

  private follow(): void {
    let picture = ''
    this.stops.push(
      sendOnceAFrame(
        () => lookAt(this.panelId, this.size.value, null),
        (view) => {
          this.client.setView(view)
          const key = `${view.layer} ${view.theme} ${JSON.stringify(view.ends)}`
          if (key !== picture) this.stale()
          picture = key
        },
      ),
      effect(() => this.setGround()),
      effect(() => this.setPath()),
      effect(() => this.placeAnts()),
      effect(() => this.turn()),
      effect(() => {
        this.scene()
        this.cursor.value
        theme.value
        pointedCell(this.panelId)
        drawSoon(this.drawMarks)
      }),
    )
  }

  private setGround(): void {
    const surface = ground.value
    if (!surface) return
    this.renderer.setGround(surface, theme.value, showContours.value)
    panelColour(this.panelId)
    drawSoon(this.draw)
  }

  private setPath(): void {
    const { lattice } = this.renderer
    const surface = ground.value
    const [bestPath, bestAltitudes] = [this.bestPath.value, this.bestAltitudes.value]
    const bySlices = scenario.value?.spec.terrain?.slices !== undefined
    if (!surface || !lattice) return
    const drawn = showPath.value && bestPath && bestAltitudes && bestPath.length > 2
    const path = drawn ? { cells: bestPath, altitudes: bestAltitudes, bySlices } : null
    this.content.setPath(path, surface, lattice, this.lift())
    drawSoon(this.draw)
  }

  private placeAnts(): void {
    const { lattice } = this.renderer
    const surface = ground.value
    if (!surface || !lattice) return
    const ants = showAnts.value ? this.ants : new Uint32Array()
    this.content.setAnts(ants, surface, lattice, this.lift())
    drawSoon(this.draw)
  }

  /** Keeps lines clear of the ground, by the same distance however it is stretched. */
  private lift(): number {
    const surface = ground.value
    return surface ? (0.003 * Math.max(surface.width, surface.height)) / stretch.value : 0
  }

  /** The eye has moved, or the ground has another height or size on the screen. */
  private turn(): void {
    eye.value
    stretch.value
    this.size.value
    this.fineness = this.drawMs > SLOW_MS ? 0.5 : 1
    clearTimeout(this.restTimer)
    if (this.fineness < 1) {
      this.restTimer = window.setTimeout(() => {
        this.fineness = 1
        drawSoon(this.draw)
      }, REST_MS)
    }
    drawSoon(this.draw)
    drawSoon(this.drawMarks)
  }

  private drawGround(): void {
    const surface = ground.peek()
    if (!surface) return
    const { width, height, dpr } = this.size.peek()
    const detail = (Math.min(MOST_DPR, dpr) / dpr) * this.fineness
    resize(this.canvas, Math.round(width * detail), Math.round(height * detail))
    this.camera.aim(eye.peek(), surface, stretch.peek(), width, height)
    this.content.setLook(panelColour(this.panelId), theme.peek(), dpr * detail)
    const began = performance.now()
    this.renderer.draw(this.content, this.camera, stretch.peek(), this.canvas, this.fineness < 1)
    const took = performance.now() - began
    // Coarse pictures say nothing about how long fine ones take.
    if (this.fineness === 1) this.drawMs = took
  }

  private drawOverlay(): void {
    const scene = this.scene()
    if (!scene) return
    const { width, height, dpr } = this.size.peek()
    resize(this.overlay, width, height)
    this.camera.aim(eye.peek(), scene.ground, scene.stretch, width, height)
    drawOverlay(this.overlay, scene, this.cursor.peek() ?? pointedCell(this.panelId), dpr)
  }
}

function newCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas')
  canvas.setAttribute('aria-hidden', 'true')
  return canvas
}

/** Setting a size, even the same, clears a canvas. */
function resize(canvas: HTMLCanvasElement, width: number, height: number): void {
  if (canvas.width !== width) canvas.width = width
  if (canvas.height !== height) canvas.height = height
}
