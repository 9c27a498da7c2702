/** Paints a difference of trails: one pixel a cell, a diverging scale between two hues that colour-blind readers tell apart. */
import type { Scenario } from '../model/session'
import { differenceAt, type Trails } from './difference'

type Rgb = [number, number, number]

interface Palette {
  /** From alike to 1: A alone. */
  a: Rgb[]
  /** From alike to −1: B alone. */
  b: Rgb[]
  wall: Rgb
}

/** Orange and blue, as far apart in lightness from the ground on both sides; the ground is that of the other maps. */
export const PALETTES: Record<'light' | 'dark', Palette> = {
  light: {
    a: [
      [251, 250, 247],
      [250, 196, 130],
      [214, 106, 18],
      [122, 50, 0],
    ],
    b: [
      [251, 250, 247],
      [158, 200, 236],
      [42, 112, 186],
      [6, 48, 108],
    ],
    wall: [61, 68, 81],
  },
  dark: {
    a: [
      [18, 21, 27],
      [122, 62, 10],
      [226, 128, 38],
      [255, 222, 166],
    ],
    b: [
      [18, 21, 27],
      [18, 66, 120],
      [70, 148, 226],
      [196, 226, 255],
    ],
    wall: [75, 84, 100],
  },
}

/** Colour of a difference from −1 to 1. Trails span decades: the root lifts weak differences out of the ground. */
export function colourOf(difference: number, palette: Palette): Rgb {
  const stops = difference >= 0 ? palette.a : palette.b
  const at = Math.min(1, Math.sqrt(Math.abs(difference))) * (stops.length - 1)
  const low = Math.min(stops.length - 2, Math.floor(at))
  const [from, to] = [stops[low] ?? palette.wall, stops[low + 1] ?? palette.wall]
  const mix = (k: 0 | 1 | 2) => Math.round(from[k] + (to[k] - from[k]) * (at - low))
  return [mix(0), mix(1), mix(2)]
}

const TONES = 512

/** One pixel a cell; without trails the bare map. */
export function paintDifference(
  canvas: OffscreenCanvas,
  { spec: { width, height }, cells }: Scenario,
  trails: Trails | null,
  theme: 'light' | 'dark',
): void {
  const context = canvas.getContext('2d')
  if (!context) return
  const palette = PALETTES[theme]
  const tones = Array.from({ length: 2 * TONES + 1 }, (_, i) => colourOf(i / TONES - 1, palette))
  const image = new ImageData(width, height)
  for (let cell = 0; cell < width * height; cell++) {
    const difference = trails ? differenceAt(trails, cell) : 0
    const free = tones[Math.round((difference + 1) * TONES)] ?? palette.wall
    const colour = cells[cell] === 1 ? palette.wall : free
    image.data.set(colour, 4 * cell)
    image.data[4 * cell + 3] = 255
  }
  context.putImageData(image, 0, 0)
}

/** The scale as a gradient of style sheets, from B alone to A alone. */
export function scaleGradient(theme: 'light' | 'dark'): string {
  const stops = Array.from(
    { length: 33 },
    (_, i) => `rgb(${colourOf(i / 16 - 1, PALETTES[theme]).join()})`,
  )
  return `linear-gradient(to right, ${stops.join()})`
}
