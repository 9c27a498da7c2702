/** Draws a figure with its lattice and the classes of its cells over it. */
import type { Lattice, Shown } from '@pkg/formicarium'
import type { Cell } from '../model/cell'
import { classOf, MARKS, type Mark } from './figure_draft'
import { HANDLES, handlePlace, type Place, placeAt } from './figure_lattice'

/** Over paper, whatever the page's colours are: red, green, blue, and how much of what lies below it covers (0–255). */
const TINTS: Record<Mark, [number, number, number, number]> = {
  free: [66, 148, 230, 52],
  wall: [214, 92, 30, 150],
  start: [11, 143, 105, 215],
  goal: [200, 52, 43, 215],
  path: [132, 72, 214, 90],
  unsure: [255, 214, 10, 225],
}

export const tintOf = (mark: Mark): string => {
  const [r, g, b, alpha] = TINTS[mark]
  return `rgb(${r} ${g} ${b} / ${Math.round(alpha / 2.55)}%)`
}

/** What lies below a tint as a rule. */
export const paperOf = (mark: Mark) => (mark === 'wall' ? '#000' : '#fff')

/** Letters that tell marks apart without their colour. */
const LETTERS: Partial<Record<Mark, string>> = { start: 'S', goal: 'G', unsure: '?' }
export const letterOf = (mark: Mark) => LETTERS[mark] ?? ''

const LINE = 'rgb(0 106 190 / 75%)'
const INK = '#14211d'
/** CSS pixels. */
export const HANDLE = 12
const LEGIBLE = 9

/** A part of the picture on a canvas: CSS pixels = (pixels of the picture) · scale + offset. */
export interface Sight {
  width: number
  height: number
  scale: number
  offset: Place
}

export interface Drawing {
  pixels: HTMLCanvasElement | null
  picture: Shown
  lattice: Lattice | null
  /** Null while they are being read. */
  classes: Uint8Array | null
  /** One pixel a cell: see `tintsOf`. */
  tints: HTMLCanvasElement | null
  cursor: Cell | null
  hasHandles: boolean
}

/** The picture's pixels as something that can be drawn in any size. */
export function pixelsOf({ rgba, shown_width, shown_height }: Shown): HTMLCanvasElement {
  const canvas = blank(shown_width, shown_height)
  const data = new ImageData(new Uint8ClampedArray(rgba), shown_width, shown_height)
  canvas.getContext('2d')?.putImageData(data, 0, 0)
  return canvas
}

/** One pixel a cell. */
export function tintsOf(classes: Uint8Array, { columns, rows }: Lattice): HTMLCanvasElement {
  const canvas = blank(columns, rows)
  const colours = MARKS.map((mark) => TINTS[mark])
  const data = new ImageData(columns, rows)
  for (let cell = 0; cell < classes.length; cell++)
    data.data.set(colours[classes[cell] ?? 0] ?? [], 4 * cell)
  canvas.getContext('2d')?.putImageData(data, 0, 0)
  return canvas
}

function blank(width: number, height: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas')
  canvas.width = width
  canvas.height = height
  return canvas
}

export function paint(canvas: HTMLCanvasElement, sight: Sight, drawing: Drawing): void {
  const context = canvas.getContext('2d')
  if (!context) return
  const dpr = devicePixelRatio
  canvas.width = Math.round(sight.width * dpr)
  canvas.height = Math.round(sight.height * dpr)
  const { scale, offset } = sight
  const toPicture = () =>
    context.setTransform(dpr * scale, 0, 0, dpr * scale, dpr * offset[0], dpr * offset[1])
  toPicture()
  const { pixels, picture, lattice, classes, tints, cursor } = drawing
  context.imageSmoothingEnabled = scale * picture.by < 3
  if (pixels)
    context.drawImage(
      pixels,
      0,
      0,
      picture.shown_width * picture.by,
      picture.shown_height * picture.by,
    )
  if (!lattice) return
  toPicture()
  const { x0, y0, dx, dy, shear_x, shear_y } = lattice
  context.transform(dx, shear_y, shear_x, dy, x0, y0)
  context.imageSmoothingEnabled = false
  if (tints) context.drawImage(tints, 0, 0)
  const onScreen = (u: number, v: number): Place => {
    const [x, y] = placeAt(lattice, u, v)
    return [x * scale + offset[0], y * scale + offset[1]]
  }
  context.setTransform(dpr, 0, 0, dpr, 0, 0)
  lines(context, lattice, onScreen, scale)
  if (classes) letters(context, lattice, classes, onScreen, scale)
  if (cursor) frame(context, cursor, onScreen)
  if (drawing.hasHandles) handles(context, lattice, sight)
}

type OnScreen = (u: number, v: number) => Place

function lines(
  context: CanvasRenderingContext2D,
  lattice: Lattice,
  onScreen: OnScreen,
  scale: number,
): void {
  const { columns, rows, dx, dy } = lattice
  context.strokeStyle = LINE
  context.lineWidth = 1
  context.beginPath()
  const line = (from: Place, to: Place) => {
    context.moveTo(...from)
    context.lineTo(...to)
  }
  // Lines closer than that would hide the picture.
  const every = Math.min(dx, dy) * scale < 4 ? Math.max(columns, rows) : 1
  for (let u = 0; u <= columns; u += Math.min(every, columns))
    line(onScreen(u, 0), onScreen(u, rows))
  for (let v = 0; v <= rows; v += Math.min(every, rows)) line(onScreen(0, v), onScreen(columns, v))
  context.stroke()
  context.lineWidth = 2
  context.beginPath()
  outline(context, [0, 0], [columns, rows], onScreen)
  context.stroke()
}

function outline(
  context: CanvasRenderingContext2D,
  [u, v]: Place,
  [toU, toV]: Place,
  onScreen: OnScreen,
): void {
  context.moveTo(...onScreen(u, v))
  for (const corner of [onScreen(toU, v), onScreen(toU, toV), onScreen(u, toV)])
    context.lineTo(...corner)
  context.closePath()
}

/** Unsure cells have a frame too: they are to stand out. */
function letters(
  context: CanvasRenderingContext2D,
  { columns, dx, dy }: Lattice,
  classes: Uint8Array,
  onScreen: OnScreen,
  scale: number,
): void {
  const size = Math.min(dx, dy) * scale
  const unsure = classOf('unsure')
  context.strokeStyle = INK
  context.fillStyle = INK
  context.lineWidth = Math.min(2, Math.max(1, size / 8))
  context.font = `700 ${Math.round(0.72 * size)}px system-ui, sans-serif`
  context.textAlign = 'center'
  context.textBaseline = 'middle'
  context.beginPath()
  for (let cell = 0; cell < classes.length; cell++) {
    const letter = LETTERS[MARKS[classes[cell] ?? 0] ?? 'free']
    if (!letter) continue
    const [u, v] = [cell % columns, Math.floor(cell / columns)]
    if (classes[cell] === unsure) outline(context, [u, v], [u + 1, v + 1], onScreen)
    context.fillStyle = classes[cell] === unsure ? INK : '#fff'
    if (size >= LEGIBLE) context.fillText(letter, ...onScreen(u + 0.5, v + 0.54))
  }
  context.stroke()
}

function frame(context: CanvasRenderingContext2D, [u, v]: Cell, onScreen: OnScreen): void {
  for (const [colour, width] of [
    ['#fff', 5],
    [INK, 2.5],
  ] as const) {
    context.strokeStyle = colour
    context.lineWidth = width
    context.beginPath()
    outline(context, [u, v], [u + 1, v + 1], onScreen)
    context.stroke()
  }
}

function handles(context: CanvasRenderingContext2D, lattice: Lattice, sight: Sight): void {
  context.lineWidth = 2
  for (const handle of HANDLES) {
    const [x, y] = handlePlace(lattice, handle)
    const left = x * sight.scale + sight.offset[0] - HANDLE / 2
    const top = y * sight.scale + sight.offset[1] - HANDLE / 2
    context.fillStyle = '#fff'
    context.strokeStyle = '#0a5aa6'
    context.fillRect(left, top, HANDLE, HANDLE)
    context.strokeRect(left, top, HANDLE, HANDLE)
  }
}
