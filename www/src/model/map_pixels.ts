/** A map as pixels, one a cell: to recognise it before it is opened. */
import type { Imported, ScenarioSpec } from '@pkg/formicarium'
import { numbersOf } from './cell_numbers'
import { hillShade } from './hill_shade'

export interface MapToShow {
  spec: ScenarioSpec
  cells: Uint8Array
  heights: Float32Array | null
}

export function mapToShow({ spec, cells, heights }: Imported): MapToShow {
  return { spec, cells, heights: numbersOf(heights) }
}

/** As the workers paint them (src/wasm/paint.rs), little-endian. */
const INK = {
  light: { free: 0xff_f7_fa_fb, blocked: 0xff_51_44_3d },
  dark: { free: 0xff_1b_15_12, blocked: 0xff_64_54_4b },
}

export function mapPixels({ spec, cells, heights }: MapToShow, theme: 'light' | 'dark'): ImageData {
  const { width, height, resolution } = spec
  const { free, blocked } = INK[theme]
  const pixels = heights
    ? hillShade(heights, width, [resolution, resolution])
    : new Uint8ClampedArray(Uint32Array.from(cells, (cell) => (cell ? blocked : free)).buffer)
  return new ImageData(pixels, width, height)
}
