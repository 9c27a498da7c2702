/** Figures of grids, read in a worker of their own: no other call waits for them, and their memory goes with it. */
import type { Figure, Imported, Lattice, Shown } from '@pkg/formicarium'
import type { MapCalls } from '../model/tool_calls'
import { ToolBox } from './tools'

/** Pixels a side of what is shown; large figures stay legible when they are enlarged. */
const MOST_SHOWN = 2048

export class FigureReader {
  private readonly box = new ToolBox<MapCalls>('whole')

  constructor(private readonly bytes: Uint8Array) {}

  /** The pixels as the engine sees them; browsers turn some pictures, and know fewer formats. */
  show = (): Promise<Shown> => this.box.call('showPicture', this.bytes, MOST_SHOWN)
  find = (): Promise<Figure> => this.box.call('findFigure', this.bytes)
  read = (lattice: Lattice): Promise<Figure> => this.box.call('readFigure', this.bytes, lattice)
  map = (classes: Uint8Array, columns: number, name: string): Promise<Imported> =>
    this.box.call('figureMap', classes, columns, name)

  /** What is still asked is never answered. */
  end(): void {
    this.box.terminate()
  }
}
