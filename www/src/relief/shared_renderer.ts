/**
 * The one WebGL context of the page. Panels draw in it one after the other and copy the picture to canvases of their own, so that ground
 * and lights are there once, and six panels need no more of the browser than one.
 */
import {
  AmbientLight,
  BufferGeometry,
  DirectionalLight,
  type Group,
  Mesh,
  Scene,
  Texture,
  WebGLRenderer,
} from 'three'
import type { PanelView } from '../model/messages'
import type { Ground } from '../model/relief_ground'
import { groundMesh, Lattice, plinthMesh } from './ground_mesh'
import { groundMaterial, plinthColour, plinthMaterial } from './materials'
import type { PanelCamera } from './panel_camera'
import type { PanelContent } from './panel_content'

/** Level ground gets about the colours of the flat map, a little brighter in the dark theme. */
const LIGHTS = { light: { sun: 2.25, sky: 1.5 }, dark: { sun: 3.2, sky: 2.1 } }

/** Of the sketch, a side. */
const SKETCH_PLACES = 97

let shared: SharedRenderer | null = null
let users = 0

/** The renderer, made for its first user. Throws where the browser offers no WebGL. */
export function acquireRenderer(onLost: () => void): SharedRenderer {
  shared ??= new SharedRenderer(onLost)
  users++
  return shared
}

/** When its last user releases it, the graphics card gets everything back. */
export function releaseRenderer(): void {
  users--
  if (users > 0) return
  shared?.dispose()
  shared = null
}

/** Whether a context is held: it should be only while something is drawn in three dimensions. */
export const rendererIsHeld = () => shared !== null

export class SharedRenderer {
  /** The ground as it is drawn; null before the first map. */
  lattice: Lattice | null = null
  private readonly renderer: WebGLRenderer
  private readonly scene = new Scene()
  private readonly ground = groundMaterial()
  private readonly plinth = plinthMaterial()
  private readonly land = new Mesh(undefined, this.ground.material)
  private readonly sides = new Mesh(undefined, this.plinth)
  /** Of few triangles, for a slow machine while it turns the map. */
  private readonly sketch = new Mesh(undefined, this.ground.material)
  private readonly sun = new DirectionalLight('#ffffff')
  private readonly sky = new AmbientLight('#ffffff')
  private readonly blank = new Texture()
  private shownGround: Ground | null = null

  constructor(private readonly onLost: () => void) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true })
    this.renderer.setScissorTest(true)
    this.renderer.domElement.addEventListener('webglcontextlost', onLost, { once: true })
    this.sun.position.set(-1, 1.25, -1)
    this.scene.add(this.land, this.sketch, this.sides, this.sun, this.sky)
  }

  setGround(ground: Ground, theme: PanelView['theme'], lines: boolean): void {
    this.ground.setLines(ground, theme, lines)
    this.plinth.color.set(plinthColour(theme))
    this.sun.intensity = LIGHTS[theme].sun
    this.sky.intensity = LIGHTS[theme].sky
    if (this.shownGround === ground && this.lattice) return
    this.shownGround = ground
    this.lattice = new Lattice(ground)
    this.disposeGround()
    this.sketch.geometry = new BufferGeometry()
    this.land.geometry = groundMesh(this.lattice, ground)
    this.sides.geometry = plinthMesh(this.lattice, -0.15 * (ground.span || 1))
  }

  /** Draws one panel and copies it to its canvas. */
  draw(
    content: PanelContent,
    camera: PanelCamera,
    stretch: number,
    onto: HTMLCanvasElement,
    roughly: boolean,
  ): void {
    const { width, height } = onto
    this.land.visible = !roughly
    this.sketch.visible = roughly
    if (roughly) this.prepareSketch()
    const drawn = this.renderer.domElement
    if (drawn.width < width || drawn.height < height)
      this.renderer.setSize(Math.max(drawn.width, width), Math.max(drawn.height, height), false)
    this.renderer.setViewport(0, 0, width, height)
    this.renderer.setScissor(0, 0, width, height)
    this.ground.material.map = content.texture ?? this.blank
    for (const object of [this.land, this.sketch, this.sides, content.group])
      object.scale.y = stretch
    this.within(content.group, () => this.renderer.render(this.scene, camera.perspective))
    const context = onto.getContext('2d')
    context?.clearRect(0, 0, width, height)
    context?.drawImage(drawn, 0, drawn.height - height, width, height, 0, 0, width, height)
  }

  private prepareSketch(): void {
    if (!this.shownGround || this.sketch.geometry.index) return
    const lattice = new Lattice(this.shownGround, SKETCH_PLACES)
    this.sketch.geometry = groundMesh(lattice, this.shownGround)
  }

  private disposeGround(): void {
    for (const { geometry } of [this.land, this.sketch, this.sides]) geometry.dispose()
  }

  private within(group: Group, render: () => void): void {
    this.scene.add(group)
    render()
    this.scene.remove(group)
  }

  dispose(): void {
    // What is given back is not lost.
    this.renderer.domElement.removeEventListener('webglcontextlost', this.onLost)
    this.disposeGround()
    for (const part of [this.ground.material, this.plinth, this.blank]) part.dispose()
    this.renderer.dispose()
    this.renderer.forceContextLoss()
  }
}
