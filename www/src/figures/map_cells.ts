/** The cells of a map as one path a colour: rectangles of neighbours of a row that have the same colour. */

/** Red, green, blue as one number; -1 for what is clear. */
type Colour = number

export interface CellPaths {
  /** Colour of most cells, under all others; null where all are clear. */
  base: string | null
  /** Of the other colours, in the order in which they first appear. */
  paths: { colour: string; d: string }[]
}

const CLEAR = -1

function colourAt(pixels: Uint8ClampedArray, cell: number): Colour {
  const [red = 0, green = 0, blue = 0, opacity = 0] = pixels.subarray(4 * cell, 4 * cell + 4)
  return opacity === 0 ? CLEAR : (red << 16) | (green << 8) | blue
}

const hex = (colour: Colour) => `#${colour.toString(16).padStart(6, '0')}`

interface Run {
  x: number
  y: number
  length: number
}

/** Null where it takes more than `most` rectangles: then a picture is smaller. */
export function cellPaths(
  pixels: Uint8ClampedArray,
  width: number,
  most: number,
): CellPaths | null {
  const runs = runsOf(pixels, width)
  const cells = ([, all]: [Colour, Run[]]) => all.reduce((sum, { length }) => sum + length, 0)
  const solid = [...runs].filter(([colour]) => colour !== CLEAR)
  // What is clear must stay so: then there is nothing under all.
  const commonest = solid.reduce<[Colour, Run[]] | null>(
    (best, each) => (best === null || cells(each) > cells(best) ? each : best),
    null,
  )
  const base = runs.has(CLEAR) || !commonest ? null : commonest[0]
  const drawn = solid.filter(([colour]) => colour !== base)
  if (drawn.reduce((sum, [, all]) => sum + all.length, 0) > most) return null
  return {
    base: base === null ? null : hex(base),
    paths: drawn.map(([colour, all]) => ({
      colour: hex(colour),
      d: all.map(({ x, y, length }) => `M${x} ${y}h${length}v1h-${length}z`).join(''),
    })),
  }
}

function runsOf(pixels: Uint8ClampedArray, width: number): Map<Colour, Run[]> {
  const runs = new Map<Colour, Run[]>()
  const cells = pixels.length / 4
  for (let from = 0, to = 0; from < cells; from = to) {
    const colour = colourAt(pixels, from)
    const end = (Math.floor(from / width) + 1) * width
    for (to = from + 1; to < end && colourAt(pixels, to) === colour; ) to++
    const run = { x: from % width, y: Math.floor(from / width), length: to - from }
    const before = runs.get(colour)
    if (before) before.push(run)
    else runs.set(colour, [run])
  }
  return runs
}
