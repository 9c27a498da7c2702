/** The engine in node, with something for it to paint on. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'

const PKG = join(__dirname, '../../../pkg')

/** Node has no canvas: this one keeps the pixels that it is given. */
export class Paper {
  pixels = ''
  putImageData(image: Picture): void {
    this.pixels = Buffer.from(image.data).toString('base64')
  }

  get context(): OffscreenCanvasRenderingContext2D {
    return this as unknown as OffscreenCanvasRenderingContext2D
  }

  /** Red, green, blue, opacity of each cell. */
  get cells(): number[][] {
    const bytes = [...Buffer.from(this.pixels, 'base64')]
    return Array.from({ length: bytes.length / 4 }, (_, i) => bytes.slice(4 * i, 4 * i + 4))
  }
}

class Picture {
  constructor(readonly data: Uint8ClampedArray) {}
}

export async function wholeEngine(): Promise<typeof import('@pkg/formicarium')> {
  Object.assign(globalThis, { OffscreenCanvasRenderingContext2D: Paper, ImageData: Picture })
  const engine = await import(join(PKG, 'formicarium.js'))
  engine.initSync({ module: readFileSync(join(PKG, 'formicarium_bg.wasm')) })
  return engine
}
