/** A map as pixels, one a cell: to recognise it before it is opened. */
import type { Imported, ScenarioSpec } from '@pkg/formicarium'
import { numbersOf } from './cell_numbers'
import { hillShade } from './hill_shade'
import type { MapCells } from './session'
import { PLAIN, strengthOf } from './weights'

export interface MapToShow extends MapCells {
  spec: ScenarioSpec
}

export function mapToShow({ spec, cells, heights, factors }: Imported): MapToShow {
  return { spec, cells, heights: numbersOf(heights), factors: numbersOf(factors) }
}

type Rgb = readonly [number, number, number]

/** As the workers paint them (src/wasm/colours.rs, ground.rs). */
const INK: Record<'light' | 'dark', Record<'free' | 'blocked' | 'dearest', Rgb>> = {
  light: { free: [251, 250, 247], blocked: [61, 68, 81], dearest: [66, 122, 126] },
  dark: { free: [18, 21, 27], blocked: [75, 84, 100], dearest: [74, 142, 140] },
}

export function mapPixels(map: MapToShow, theme: 'light' | 'dark'): ImageData {
  const { width, height, resolution } = map.spec
  const pixels = map.heights
    ? hillShade(map.heights, width, [resolution, resolution])
    : planePixels(map, INK[theme])
  return new ImageData(pixels, width, height)
}

/** Of a plane: free cells are the more tinted the more their ground costs. */
export function planePixels(
  { cells, factors }: Pick<MapCells, 'cells' | 'factors'>,
  { free, blocked, dearest }: Record<'free' | 'blocked' | 'dearest', Rgb>,
): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * cells.length).fill(255)
  for (let i = 0; i < cells.length; i++) {
    const part = strengthOf(factors?.[i] ?? PLAIN)
    const mixed = (channel: 0 | 1 | 2) => free[channel] + (dearest[channel] - free[channel]) * part
    pixels.set(cells[i] === 1 ? blocked : [mixed(0), mixed(1), mixed(2)], 4 * i)
  }
  return pixels
}
